#pragma once
/// Law 4: the report's empirical 9-parameter nonlinear viscoelastic foam.
///
///   loading:   G = A(e) B(de/dt),    A = e^m / (1 - e)^n,   B = E_inf + E_r |de/dt|^r,   h = 1/tau
///   unloading: G = A B E(e, e*, D)   with E and D of dashpad/pad/unloading.hpp
///                                                   (theory.md, Eqs. 12 to 14; report, Eq. 28, KEYP = 4)
///
/// Stress and strain are engineering values, compression positive. |de/dt|^r and (tau* |de/dt|)^p take the
/// rate in 1/s. The ninth parameter, the zero-time modulus E_0, does not enter the law and is left out, as
/// in the 1984 program.

#include <array>
#include <cmath>

#include "dashpad/pad/parameter.hpp"
#include "dashpad/pad/power_shape.hpp"
#include "dashpad/pad/unloading.hpp"

namespace dashpad {

struct NineParameter {
  double asymptotic_modulus = 0;        ///< E_inf, Pa, > 0
  double contact_exponent = 0;          ///< m, in (0, 1]
  double compaction_exponent = 0;       ///< n, in [0, 4]
  double relaxation_time = 0;           ///< tau, s, > 0
  double rate_modulus = 0;              ///< E_r, Pa at 1/s, >= 0
  double rate_exponent = 0;             ///< r, in (0, 1]
  double residual_strain_time = 0;      ///< tau*, s, > 0
  double residual_strain_exponent = 0;  ///< p, in (0, 1]

  static constexpr const char* name = "nine-parameter";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<NineParameter>, 8> parameters;

  struct StrainPart {
    double shape = 0;  ///< A(e)
  };
  struct RatePart {
    double modulus = 0;         ///< B
    double residual_ratio = 0;  ///< D, used on unloading
    bool unloading = false;
  };
  struct TimePart {
    double decay = 1;
  };

  [[nodiscard]] PowerExponents exponents() const { return {contact_exponent, compaction_exponent}; }
  [[nodiscard]] StrainPart strain_part(Strain, const PowerShape::Value& power) const { return {power.shape}; }
  [[nodiscard]] RatePart rate_part(double rate) const {
    if (rate == 0) return {asymptotic_modulus, 0, false};
    const double log_rate = std::log(std::abs(rate));
    RatePart part{asymptotic_modulus + rate_modulus * std::exp(rate_exponent * log_rate), 0, rate < 0};
    if (part.unloading)
      part.residual_ratio = residual_ratio(log_rate, residual_strain_time, residual_strain_exponent);
    return part;
  }
  [[nodiscard]] double envelope(StrainPart part, RatePart rate, double strain, double largest_strain) const {
    const double loading = part.shape * rate.modulus;
    return rate.unloading && strain > 0
               ? loading * unloading_factor(strain, largest_strain, rate.residual_ratio)
               : loading;
  }
  /// dG/de with rate and largest strain held: A' B on loading, A' B E + A B dE/de on unloading. Strain > 0.
  [[nodiscard]] double envelope_slope(Strain strain, const PowerShape& power, RatePart rate,
                                      double largest_strain) const {
    const double value = power.at(strain).shape * rate.modulus;
    const double slope = value * power.log_slope(strain);
    if (!rate.unloading) return slope;
    return slope * unloading_factor(strain.value, largest_strain, rate.residual_ratio) +
           value * unloading_factor_slope(strain.value, largest_strain, rate.residual_ratio);
  }
  [[nodiscard]] TimePart time_part(double from, double to) const {
    return {std::exp((from - to) / relaxation_time)};
  }
  [[nodiscard]] double decay(TimePart time, double, double, double) const { return time.decay; }
  [[nodiscard]] double relaxation_rate(double, double) const { return 1 / relaxation_time; }
  [[nodiscard]] double edge_ratio(RatePart rate) const { return rate.modulus; }
};

inline constexpr std::array<Parameter<NineParameter>, 8> NineParameter::parameters{{
    {"asymptotic_modulus", "E_inf", "Pa", &NineParameter::asymptotic_modulus, positive,
     "modulus of the lasting stress"},
    {"contact_exponent", "m", "1", &NineParameter::contact_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true}, "exponent of the strain"},
    {"compaction_exponent", "n", "1", &NineParameter::compaction_exponent,
     Bounds{.lowest = 0, .highest = 4, .lowest_admitted = true, .highest_admitted = true},
     "exponent of one minus the strain"},
    {"relaxation_time", "tau", "s", &NineParameter::relaxation_time, positive,
     "time constant of the relaxation"},
    {"rate_modulus", "E_r", "Pa", &NineParameter::rate_modulus, not_negative,
     "modulus of the stress that a strain rate of 1/s adds"},
    {"rate_exponent", "r", "1", &NineParameter::rate_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true}, "exponent of the strain rate"},
    {"residual_strain_time", "tau*", "s", &NineParameter::residual_strain_time, positive,
     "scale of the strain rate in the residual strain on unloading"},
    {"residual_strain_exponent", "p", "1", &NineParameter::residual_strain_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true}, "its exponent"},
}};

}  // namespace dashpad
