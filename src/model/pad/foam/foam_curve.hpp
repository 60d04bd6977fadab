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
    const double area = x * (a + t * (b / 2 + t * (c / 3 + t * d / 4))) +
                        h * t * (a / 2 + t * (b / 3 + t * (c / 4 + t * d / 5)));
    return {a + t * (b + t * (c + t * d)), work_[place.cell] + 2 * h * t * area};
  }
  [[nodiscard]] Point beyond(Strain e) const {
    const double n = exponent_;
    const double power = inverse_power(e.complement);
    const double integral = std::abs(n - 1) < 1e-9
                                ? -std::log(e.complement / last_complement_)
                                : (power * e.complement - last_power_ * last_complement_) / (n - 1);
    return {
        last_.stress + growth_ * (power - last_power_),
        last_.work + (last_.stress - growth_ * last_power_) * (e.value - last_strain_) + growth_ * integral};
  }
  [[nodiscard]] Point at(Strain e) const {
    if (e.value >= last_strain_) return beyond(e);
    return within(cells_.place(std::sqrt(std::max(e.value, 0.0))));
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

 private:
  /// q^-n; a whole exponent, as most cards have it, needs no logarithm.
  [[nodiscard]] double inverse_power(double q) const {
    if (exponent_ == 2) return 1 / (q * q);
    return std::pow(q, -exponent_);
  }

  double exponent_ = 2;
  double last_strain_ = 1;
  double last_complement_ = 0;
  double last_power_ = 0;
  double growth_ = 0;  ///< c
  Point last_;
  Cells cells_;
  CellTable stress_;
  std::vector<double> work_;  ///< at the start of each cell
};

}  // namespace dashpad
