#pragma once
/// A base curve made ready: stress and work at any strain, with its continuation beyond the last tested one.
///
///   s(e) = s_h + c ((1 - e)^-n - (1 - e_h)^-n),  c = s'_h (1 - e_h)^(n+1) / n,  e > e_h  (theory.md, Eq. 37)
///   W(e) = integral of s from 0 to e                                                        (theory.md, Eq.
///   32)
///
/// Stress in Pa, work in J per m3 of foam, compression positive.

#include <cmath>

#include "dashpad/model/pad/foam/base_curve.hpp"
#include "dashpad/model/pad/strain.hpp"
#include "model/pad/foam/cell_table.hpp"

namespace dashpad {

/// Strain up to which a base curve was tested.
double last_strain_of(const BaseCurve& base);

class FoamCurve {
 public:
  FoamCurve() = default;
  /// The curve must be sound (violations(PadLaw)).
  FoamCurve(const BaseCurve& base, double continuation_exponent);

  [[nodiscard]] double last_strain() const { return last_strain_; }
  [[nodiscard]] const Cells& cells() const { return cells_; }

  struct Point {
    double stress = 0;
    double work = 0;
  };
  /// Up to the last tested strain.
  [[nodiscard]] Point within(CellPlace place) const {
    const auto& [a, b, c, d] = stress_.cubic(place.cell);
    const double t = place.t;
    const double h = cells_.width;
    const double x = h * static_cast<double>(place.cell);
    constexpr double third = 1.0 / 3;
    const double area = x * (a + t * (b * 0.5 + t * (c * third + t * d * 0.25))) +
                        h * t * (a * 0.5 + t * (b * third + t * (c * 0.25 + t * d * 0.2)));
    return {a + t * (b + t * (c + t * d)), work_[place.cell] + 2 * h * t * area};
  }
  [[nodiscard]] Point beyond(Strain e) const { return beyond(e, inverse_power(e.complement)); }
  /// `power`: (1 - e)^-n.
  [[nodiscard]] Point beyond(Strain e, double power) const {
    return {last_.stress + growth_ * (power - last_power_),
            last_.work + (last_.stress - growth_ * last_power_) * (e.value - last_strain_) +
                growth_ * area_of_power(exponent_, e.complement, power, last_power_)};
  }
  [[nodiscard]] Point at(Strain e) const {
    if (e.value >= last_strain_) return beyond(e);
    return within(cells_.place(std::sqrt(std::max(e.value, 0.0))));
  }
  /// Integral of e s(e) from 0 to a strain, J per m3 of foam.
  [[nodiscard]] double moment(Strain e) const {
    if (e.value >= last_strain_) return moment_beyond(e);
    return moment_within(cells_.place(std::sqrt(std::max(e.value, 0.0))));
  }
  [[nodiscard]] double moment_within(CellPlace place) const {
    const auto& [a, b, c, d] = stress_.cubic(place.cell);
    const double t = place.t;
    const double x = cells_.width * static_cast<double>(place.cell);
    const double y = cells_.width * t;
    const auto mean = [&](int k) { return a / k + t * (b / (k + 1) + t * (c / (k + 2) + t * d / (k + 3))); };
    return moment_[place.cell] +
           2 * y * (x * x * (x * mean(1) + 3 * y * mean(2)) + y * y * (3 * x * mean(3) + y * mean(4)));
  }
  /// Slope of the stress beyond the last tested strain, Pa; 0 up to it.
  [[nodiscard]] double slope_beyond(Strain e) const {
    if (e.value <= last_strain_) return 0;
    return growth_ * exponent_ * inverse_power(e.complement) / e.complement;
  }

  /// Beyond the last tested strain, where the slope is `slope` or its change over `ahead` is as large as
  /// itself, whichever comes last: the complement is the smaller of the two.
  [[nodiscard]] double strain_where_steep(double slope, double ahead) const {
    const double steep = std::pow(growth_ * exponent_ / slope, 1 / (exponent_ + 1));
    return std::max(1 - std::min(steep, (exponent_ + 1) * ahead), last_strain_);
  }

  /// q^-n; a whole exponent, as most cards have it, needs no logarithm.
  [[nodiscard]] double inverse_power(double q) const {
    if (exponent_ == 2) return 1 / (q * q);
    return std::pow(q, -exponent_);
  }

 private:
  /// Integral of p^-k for p from q to the complement of the last tested strain; `power` and
  /// `last_power` are the powers at both ends.
  [[nodiscard]] double area_of_power(double k, double q, double power, double last_power) const {
    if (std::abs(k - 1) < 1e-9) return -std::log(q / last_complement_);
    return (power * q - last_power * last_complement_) / (k - 1);
  }
  [[nodiscard]] double moment_beyond(Strain e) const {
    const double q = e.complement;
    const double power = inverse_power(q);
    const double even = last_.stress - growth_ * last_power_;
    return last_moment_ + even * (e.value * e.value - last_strain_ * last_strain_) / 2 +
           growth_ * (area_of_power(exponent_, q, power, last_power_) -
                      area_of_power(exponent_ - 1, q, power * q, last_power_ * last_complement_));
  }

  double exponent_ = 2;
  double last_strain_ = 1;
  double last_complement_ = 0;
  double last_power_ = 0;
  double growth_ = 0;  ///< c
  Point last_;
  Cells cells_;
  CellTable stress_;
  double last_moment_ = 0;
  std::vector<double> work_;    ///< at the start of each cell
  std::vector<double> moment_;  ///< the same of e s
};

}  // namespace dashpad
