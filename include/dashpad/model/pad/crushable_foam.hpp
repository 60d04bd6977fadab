#pragma once
/// Foam that stays crushed: a crush curve, its rise with the rate, and elastic unloading with a modulus.
///
///   stress = max(s(e*) - E (e* - e), 0) + Q(e, u)                           (theory.md, Eq. 38)
///   Q(e, u) = s(e) (m(e, u) - 1)  for u >= 0, else 0
///
/// s is the crush curve of the slowest test, e* the largest strain so far. Unloaded, the foam keeps the
/// strain e* - s(e*) / E and leaves a gap. m and u are those of foam (dashpad/model/pad/foam.hpp).
///
/// Engineering values, compression positive; E is at least the steepest slope of s.

#include <array>

#include "dashpad/model/pad/foam.hpp"

namespace dashpad {

struct CrushableFoam {
  double unloading_modulus = 0;      ///< E, Pa, > 0
  double lag_strain = 0.005;         ///< l, [1e-4, 0.05]
  double continuation_exponent = 2;  ///< n, [1, 6]
  double gentlest_continuation = 1;  ///< lower end of the range of n for intervals, [1, n]
  double steepest_continuation = 4;  ///< upper end of the range of n for intervals, [n, 6]
  FoamCurves curves;

  static constexpr const char* name = "crushable-foam";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<CrushableFoam>, 5> parameters;

  friend bool operator==(const CrushableFoam&, const CrushableFoam&) = default;
};

inline constexpr std::array<Parameter<CrushableFoam>, 5> CrushableFoam::parameters{{
    {"unloading_modulus", "E", "Pa", &CrushableFoam::unloading_modulus, positive, "unloading modulus"},
    {"lag_strain", "l", "1", &CrushableFoam::lag_strain, lag_strains,
     "strain over which the stress adapts to a change in strain rate", LeftOut::as_default},
    {"continuation_exponent", "n", "1", &CrushableFoam::continuation_exponent, continuation_exponents,
     "exponent of (1 - strain) in the curve beyond the last tested strain", LeftOut::as_default},
    {"gentlest_continuation", "n_low", "1", &CrushableFoam::gentlest_continuation, continuation_exponents,
     "lower bound on continuation_exponent", LeftOut::as_default},
    {"steepest_continuation", "n_high", "1", &CrushableFoam::steepest_continuation, continuation_exponents,
     "upper bound on continuation_exponent", LeftOut::as_default},
}};

}  // namespace dashpad
