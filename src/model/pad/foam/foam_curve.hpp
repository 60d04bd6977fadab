#pragma once
/// A base curve prepared for evaluation: stress and work at any strain, continued beyond the tested ones.
///
///   s(e) = s_h + c ((1 - e)^-n - (1 - e_h)^-n),  c = s'_h (1 - e_h)^(n+1) / n,  e > e_h  (theory.md, Eq. 37)
///   W(e) = integral of s from 0 to e                                                     (theory.md, Eq. 32)
///
/// Stress in Pa, work in J per m3 of foam, compression positive.

#include <cmath>

#include "dashpad/model/pad/foam.hpp"
#include "dashpad/model/pad/strain.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/cell_table.hpp"
#include "model/pad/scalar.hpp"

namespace dashpad {

/// State at the start of the continuation, and the numbers of Eq. 37.
struct Continuation {
  double exponent = 2;
  double strain = 1;  ///< last tested strain
  double complement = 0;
  double stress = 0;
  double work = 0;
  double power = 0;   ///< complement^-n
  double growth = 0;  ///< c
};

namespace scalar {
#include "model/pad/foam/foam_formulas.hpp"
}  // namespace scalar

/// Last tested strain of a base curve.
double last_strain_of(const BaseCurve& base);

class FoamCurve {
 public:
  FoamCurve() = default;
  /// The curve must be sound (violations(PadLaw)).
  FoamCurve(const BaseCurve& base, double continuation_exponent);

  [[nodiscard]] double last_strain() const { return last_.strain; }
  /// Exponent n beyond the last tested strain.
  [[nodiscard]] double continuation_exponent() const { return last_.exponent; }
  [[nodiscard]] const Cells& cells() const { return cells_; }

  struct Point {
    double stress = 0;
    double work = 0;
  };
  /// Stress and work up to the last tested strain.
  [[nodiscard]] Point within(CellPlace place) const {
    const auto& [a, b, c, d] = stress_.cubic(place.cell);
    const scalar::Cubic<double> cubic{a, b, c, d};
    const double x = cells_.width * static_cast<double>(place.cell);
    return {value_of(cubic, place.t), work_[place.cell] + work_of(cubic, x, cells_.width, place.t)};
  }
  [[nodiscard]] Point beyond(Strain e) const {
    const double power = inverse_power(e.complement);
    return {last_.stress + last_.growth * (power - last_.power),
            scalar::work_beyond(last_, e.value, e.complement, power)};
  }
  [[nodiscard]] Point at(Strain e) const {
    if (e.value >= last_.strain) return beyond(e);
    return within(cells_.place(std::sqrt(std::max(e.value, 0.0))));
  }
  /// Integral of e s(e) from 0 to a strain, J per m3 of foam.
  [[nodiscard]] double moment(Strain e) const {
    if (e.value >= last_.strain) return moment_beyond(e);
    return moment_within(cells_.place(std::sqrt(std::max(e.value, 0.0))));
  }
  [[nodiscard]] double moment_within(CellPlace place) const {
    const auto& cubic = stress_.cubic(place.cell);
    const double t = place.t;
    const double x = cells_.width * static_cast<double>(place.cell);
    const double y = cells_.width * t;
    const auto mean = [t, &cubic](int k) {
      return cubic[0] / k + t * (cubic[1] / (k + 1) + t * (cubic[2] / (k + 2) + t * cubic[3] / (k + 3)));
    };
    return moment_[place.cell] +
           2 * y * (x * x * (x * mean(1) + 3 * y * mean(2)) + y * y * (3 * x * mean(3) + y * mean(4)));
  }
  /// Slope of the stress beyond the last tested strain, Pa; 0 up to it.
  [[nodiscard]] double slope_beyond(Strain e) const {
    if (e.value <= last_.strain) return 0;
    return last_.growth * last_.exponent * inverse_power(e.complement) / e.complement;
  }

  /// The strain beyond the last tested one at which the stress has the slope `slope`, or at which the slope
  /// changes over `ahead` by as much as itself, whichever is larger.
  [[nodiscard]] double strain_where_steep(double slope, double ahead) const {
    const double steep = portable::pow(last_.growth * last_.exponent / slope, 1 / (last_.exponent + 1));
    return std::max(1 - std::min(steep, (last_.exponent + 1) * ahead), last_.strain);
  }

  /// q^-n.
  [[nodiscard]] double inverse_power(double q) const { return scalar::inverse_power(last_, q); }

  /// The tables for batches of places.
  struct Rows {
    const double* stress = nullptr;  ///< rows of four numbers for each cell
    const double* work = nullptr;    ///< at the start of each cell
    Cells cells;
    Continuation beyond;
  };
  [[nodiscard]] Rows rows() const { return {stress_.rows(), work_.data(), cells_, last_}; }

 private:
  [[nodiscard]] double moment_beyond(Strain e) const {
    const double q = e.complement;
    const double power = inverse_power(q);
    const double n = last_.exponent;
    const double even = last_.stress - last_.growth * last_.power;
    return last_moment_ + even * (e.value * e.value - last_.strain * last_.strain) / 2 +
           last_.growth * (scalar::area_of_power(last_, n, q, power, last_.power) -
                           scalar::area_of_power(last_, n - 1, q, power * q, last_.power * last_.complement));
  }

  Continuation last_;
  Cells cells_;
  CellTable stress_;
  double last_moment_ = 0;
  std::vector<double> work_;    ///< at the start of each cell
  std::vector<double> moment_;  ///< moment at the start of each cell
};

}  // namespace dashpad
