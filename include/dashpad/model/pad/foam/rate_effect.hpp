#pragma once
/// The rate effect m(e, r) of a foam: stress in a test at the constant rate r over that of the base curve.
///
///   m(e, r) = s(e, r) / s(e),   m = 1 at and below the slowest tested rate
///
/// Between tested rates ln m is linear in ln r, above the highest constant; it must not fall. Rates in 1/s.

#include <array>
#include <variant>
#include <vector>

#include "dashpad/model/pad/foam/table_curve.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

/// Only one rate was tested, or the rate has no effect.
struct NoRateEffect {
  static constexpr const char* name = "none";
  friend bool operator==(const NoRateEffect&, const NoRateEffect&) = default;
};

/// After Nagy, Ko and Lindholm (Journal of Cellular Plastics 10, 1974): m = (r / r_1)^max(a + b e, 0).
struct PowerRateEffect {
  double exponent = 0;        ///< a, [0, 1]
  double exponent_slope = 0;  ///< b, [-5, 5]
  double highest_rate = 0;    ///< 1/s, > the slowest tested rate r_1

  static constexpr const char* name = "power";
  static const std::array<Parameter<PowerRateEffect>, 3> parameters;
  friend bool operator==(const PowerRateEffect&, const PowerRateEffect&) = default;
};

/// The same factor at all strains.
struct FactorRateEffect {
  std::vector<double> rate;    ///< 1/s, increasing, above the slowest tested rate
  std::vector<double> factor;  ///< m, >= 1, not falling

  static constexpr const char* name = "factor";
  friend bool operator==(const FactorRateEffect&, const FactorRateEffect&) = default;
};

/// Whole curves at higher rates. Beyond the last strain of a curve its ratio to the base curve is constant.
struct CurvesRateEffect {
  struct AtRate {
    double rate = 0;  ///< 1/s
    TableCurve curve;
    friend bool operator==(const AtRate&, const AtRate&) = default;
  };
  std::vector<AtRate> curves;  ///< rates increasing, above the slowest tested rate
  /// Whether the stress is linear in the rate between two tested rates, as in decks of other solvers.
  bool linear = false;

  static constexpr const char* name = "curves";
  friend bool operator==(const CurvesRateEffect&, const CurvesRateEffect&) = default;
};

using RateEffect = std::variant<NoRateEffect, PowerRateEffect, FactorRateEffect, CurvesRateEffect>;

inline constexpr std::size_t max_rates = 50;

inline constexpr std::array<Parameter<PowerRateEffect>, 3> PowerRateEffect::parameters{{
    {"exponent", "a", "1", &PowerRateEffect::exponent, from_to(0, 1), "exponent of the rate at zero strain"},
    {"exponent_slope", "b", "1", &PowerRateEffect::exponent_slope, from_to(-5, 5),
     "change in the exponent per unit strain"},
    {"highest_rate", "r_h", "1/s", &PowerRateEffect::highest_rate, positive, "highest tested strain rate"},
}};

}  // namespace dashpad
