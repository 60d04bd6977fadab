#pragma once
/// Law 2: linear viscoelastic pad (the standard linear solid).
///
///   G = E_inf e + (E_0 - E_inf) tau de/dt,  h = 1/tau              (theory.md, Eq. 9; report, KEYP = 2)
///
/// Stress and strain are engineering values, compression positive. The law is the same on loading and
/// unloading. A sudden strain is met with the modulus E_0, a lasting one with E_inf.

#include <array>
#include <cmath>

#include "dashpad/pad/parameter.hpp"
#include "dashpad/pad/power_shape.hpp"

namespace dashpad {

struct LinearViscoelastic {
  double asymptotic_modulus = 0;  ///< E_inf, Pa, > 0
  double initial_modulus = 0;     ///< E_0, Pa, >= E_inf
  double relaxation_time = 0;     ///< tau, s, > 0

  static constexpr const char* name = "linear-viscoelastic";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<LinearViscoelastic>, 3> parameters;

  struct StrainPart {
    double equilibrium_stress = 0;  ///< E_inf e
  };
  struct RatePart {
    double viscous_stress = 0;  ///< (E_0 - E_inf) tau de/dt
  };
  struct TimePart {
    double decay = 1;
    double duration = 0;  ///< in relaxation times
  };

  [[nodiscard]] PowerExponents exponents() const { return {1, 0}; }
  [[nodiscard]] StrainPart strain_part(Strain strain, const PowerShape::Value&) const {
    return {asymptotic_modulus * strain.value};
  }
  [[nodiscard]] RatePart rate_part(double rate) const {
    return {(initial_modulus - asymptotic_modulus) * relaxation_time * rate};
  }
  [[nodiscard]] double envelope(StrainPart part, RatePart rate, double, double) const {
    return part.equilibrium_stress + rate.viscous_stress;
  }
  /// dG/de with the rate held: E_inf.
  [[nodiscard]] double envelope_slope(Strain, const PowerShape&, RatePart, double) const {
    return asymptotic_modulus;
  }
  [[nodiscard]] TimePart time_part(double from, double to) const {
    const double duration = (to - from) / relaxation_time;
    return {std::exp(-duration), duration};
  }
  /// A column that is touched within the step relaxes for its share of it: G is not 0 there.
  [[nodiscard]] double decay(TimePart time, double, double, double share) const {
    return share < 1 ? std::exp(-time.duration * share) : time.decay;
  }
  [[nodiscard]] double relaxation_rate(double, double) const { return 1 / relaxation_time; }
  /// Limit of stress / A at the contact edge, where the strain has just begun to grow.
  [[nodiscard]] double edge_ratio(RatePart) const { return initial_modulus; }
};

inline constexpr std::array<Parameter<LinearViscoelastic>, 3> LinearViscoelastic::parameters{{
    {"asymptotic_modulus", "E_inf", "Pa", &LinearViscoelastic::asymptotic_modulus, positive,
     "modulus under a lasting strain"},
    {"initial_modulus", "E_0", "Pa", &LinearViscoelastic::initial_modulus, positive,
     "modulus under a sudden strain, not below asymptotic_modulus"},
    {"relaxation_time", "tau", "s", &LinearViscoelastic::relaxation_time, positive,
     "time constant of the relaxation"},
}};

}  // namespace dashpad
