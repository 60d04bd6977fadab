#pragma once
/// The stress q added by the rate to a foam's base curve, over that curve.
///
///   q(e, u) = f u / (u + 2 u0) + m(e, u) - 1      for u >= 0                     (theory.md, Eq. 33)
///   q(e, u) = f u / (|u| + 2 u0) - k (m(e, |u|) - 1)  for u < 0

#include <cmath>
#include <cstddef>
#include <vector>

#include "dashpad/model/pad/foam.hpp"
#include "model/pad/foam/cell_table.hpp"
#include "model/pad/foam/foam_curve.hpp"

namespace dashpad {

class Overstress {
 public:
  Overstress() = default;
  /// The curves must be sound. `slip_rate`: u0, 1/s.
  Overstress(const FoamCurves& curves, const FoamCurve& base, double friction, double recoil,
             double slip_rate);

  struct Value {
    double stress = 0;  ///< q
    double rise = 0;    ///< magnitude of dq/d(ln |u|)
  };
  /// Quantities common to all strains at a slip rate.
  struct AtRate {
    double friction = 0;       ///< friction term of q
    double friction_rise = 0;  ///< its derivative by ln u
    double share = 0;          ///< factor of m - 1 in q: 1, -k or 0
    std::size_t segment = 0;   ///< index of the tested rate below u
    double weight = 0;         ///< weight of the next tested rate
    double weight_rise = 0;    ///< its derivative by ln u
    double log_rate = 0;       ///< ln of the rate over the slowest one, for a power
    bool even = false;         ///< whether q is the same at all strains, at_all_strains
    Value at_all_strains;
  };
  [[nodiscard]] AtRate at(double slip_rate) const;
  /// The strain at which a rate effect that shrinks with the strain vanishes with a corner; 0: none.
  [[nodiscard]] double strain_of_corner() const {
    return kind_ == Kind::power && exponent_slope_ < 0 ? -exponent_ / exponent_slope_ : 0;
  }
  /// Whether q follows the points of tested curves.
  [[nodiscard]] bool has_points() const { return !tables_.empty(); }
  /// The highest tested rate below a slip rate, 1/s, at which q has a corner; 0: none.
  [[nodiscard]] double corner_below(double slip_rate) const;
  [[nodiscard]] Value of(const AtRate& rate, double strain, CellPlace place) const {
    return rate.even ? rate.at_all_strains : at_strain(rate, strain, place);
  }
  /// The same for batches of places, at a rate for which q is not even.
  struct Rows {
    bool by_power = false;
    double exponent = 0;
    double exponent_slope = 0;
    bool linear = false;
    const double* before = nullptr;  ///< rows of factor() at the tested rate below; null: the slowest
    const double* next = nullptr;
  };
  [[nodiscard]] Rows rows(const AtRate& rate) const {
    if (kind_ == Kind::power) return {true, exponent_, exponent_slope_};
    if (tables_.empty()) return {};
    const double* before = rate.segment > 0 ? tables_[rate.segment - 1].rows() : nullptr;
    return {false, 0, 0, linear_, before, tables_[rate.segment].rows()};
  }

 private:
  enum class Kind { none, power, tested };
  [[nodiscard]] AtRate rates_at(double slip_rate) const;
  [[nodiscard]] Value at_strain(const AtRate& rate, double strain, CellPlace place) const;
  /// ln m, or m if it is linear in the rate, at a tested rate (0: the slowest).
  [[nodiscard]] double factor(std::size_t rate, CellPlace place) const {
    if (rate == 0) return linear_ ? 1 : 0;
    return tables_.empty() ? log_factors_[rate] : tables_[rate - 1].at(place);
  }

  Kind kind_ = Kind::none;
  bool linear_ = false;
  double friction_ = 0;
  double recoil_ = 1;
  double slip_rate_ = 1e-5;
  double exponent_ = 0;
  double exponent_slope_ = 0;
  std::vector<double> rates_{1};     ///< tested rates, the slowest first, 1/s
  std::vector<double> log_rates_;    ///< their logarithms
  std::vector<double> log_factors_;  ///< ln m, the same at all strains
  std::vector<CellTable> tables_;    ///< factor() as a function of the strain, from the second rate on
};

}  // namespace dashpad
