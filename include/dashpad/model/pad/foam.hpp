#pragma once
/// Foam that recovers: a base curve, its rise with the rate, and unloading that depends on the work done.
///
///   stress = (1 - f) s(e) D(W(e) / W(e*)) + s(e) q(e, u)                   (theory.md, Eq. 32)
///   D(x)   = 1 - (1 - HU) (1 - x^SHAPE),  or by an unloading curve
///   q      = f u / (|u| + 2 u0) + m(e, u) - 1  for u >= 0,  - k (m(e, |u|) - 1) for u < 0   (Eq. 33)
///
/// s is the base curve, the loading curve of the slowest test; W its area; e* the largest strain so far; m
/// the rate effect. The slip rate u follows the strain rate with a lag of a small strain (theory.md, Eq. 34),
/// so that the stress does not jump. No closed path of strain yields energy (theory.md, Eqs. 35 and 36).
///
/// Engineering values, compression positive. violations(PadLaw) checks the consistency of the numbers.

#include <array>
#include <optional>
#include <variant>

#include "dashpad/model/pad/foam/avalle_curve.hpp"
#include "dashpad/model/pad/foam/gibson_ashby_curve.hpp"
#include "dashpad/model/pad/foam/hyperfoam_curve.hpp"
#include "dashpad/model/pad/foam/power_curve.hpp"
#include "dashpad/model/pad/foam/rate_effect.hpp"
#include "dashpad/model/pad/foam/table_curve.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

/// Base curve of a foam, the stress over the strain in its slowest test, in one of five forms.
using BaseCurve = std::variant<TableCurve, AvalleCurve, PowerCurve, GibsonAshbyCurve, HyperfoamCurve>;

/// The curves of the tests of a foam.
struct FoamCurves {
  BaseCurve base;
  double slowest_rate = 0;  ///< strain rate of the base curve's test, 1/s, > 0
  RateEffect rate_effect;

  friend bool operator==(const FoamCurves&, const FoamCurves&) = default;
};

struct Foam {
  double friction = 0;               ///< f, [0, 0.45]
  double unloading_factor = 1;       ///< HU, [0, 1]
  double unloading_shape = 1;        ///< SHAPE, [0.01, 50]
  double recoil = 1;                 ///< k, [0, 1]
  double lag_strain = 0.005;         ///< l, [1e-4, 0.05]
  double continuation_exponent = 2;  ///< n, [1, 6]
  double gentlest_continuation = 1;  ///< lower end of the range of n for intervals, [1, n]
  double steepest_continuation = 4;  ///< upper end of the range of n for intervals, [n, 6]
  FoamCurves curves;
  /// Stress on the way back from the last strain of the base curve; it replaces HU and SHAPE.
  std::optional<TableCurve> unloading_curve;

  static constexpr const char* name = "foam";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<Foam>, 8> parameters;

  friend bool operator==(const Foam&, const Foam&) = default;
};

/// Whether the foam loses no energy, as neither friction nor an unloading nor a rate effect was stated.
inline bool is_without_loss(const Foam& foam) {
  return foam.friction == 0 && foam.unloading_factor == 1 && !foam.unloading_curve &&
         std::holds_alternative<NoRateEffect>(foam.curves.rate_effect);
}

inline constexpr Bounds lag_strains = from_to(1e-4, 0.05);
inline constexpr Bounds continuation_exponents = from_to(1, 6);

inline constexpr std::array<Parameter<Foam>, 8> Foam::parameters{{
    {"friction", "f", "1", &Foam::friction, from_to(0, 0.45),
     "friction stress as a fraction of the base stress, however slow the test", LeftOut::as_default},
    {"unloading_factor", "HU", "1", &Foam::unloading_factor, from_to(0, 1),
     "fraction of the stress that remains when the foam is nearly unloaded", LeftOut::as_default},
    {"unloading_shape", "SHAPE", "1", &Foam::unloading_shape, from_to(0.01, 50),
     "exponent of the work ratio in unloading", LeftOut::as_default},
    {"recoil", "k", "1", &Foam::recoil, from_to(0, 1),
     "fraction of the rate-dependent stress that resists recovery", LeftOut::as_default},
    {"lag_strain", "l", "1", &Foam::lag_strain, lag_strains,
     "strain over which the stress adapts to a change in strain rate", LeftOut::as_default},
    {"continuation_exponent", "n", "1", &Foam::continuation_exponent, continuation_exponents,
     "exponent of (1 - strain) in the curve beyond the last tested strain", LeftOut::as_default},
    {"gentlest_continuation", "n_low", "1", &Foam::gentlest_continuation, continuation_exponents,
     "lower bound on continuation_exponent", LeftOut::as_default},
    {"steepest_continuation", "n_high", "1", &Foam::steepest_continuation, continuation_exponents,
     "upper bound on continuation_exponent", LeftOut::as_default},
}};

}  // namespace dashpad
