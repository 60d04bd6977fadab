#pragma once
/// Law 5: the report's empirical 21-parameter nonlinear viscoelastic foam.
///
///   loading:   G = E_inf A(e) + S_r |de/dt|^(R exp(-e^U/V)) (exp(e^W/X) - exp(-e^Y/Z))
///   unloading: G = [the same] E(e, e*, D)   with E and D of dashpad/pad/unloading.hpp
///   h = a t^(a-1) / (b c^e)   with t the time since first contact, in s
///                                                (theory.md, Eqs. 12, 14, 15; report, Eq. 28, KEYP = 5)
///
/// Stress and strain are engineering values, compression positive; the rate powers take 1/s. Parameters 17
/// to 21 of the report (the zero-time stress) do not enter the law and are left out, as in the 1984 program.

#include <array>
#include <cmath>

#include "dashpad/pad/parameter.hpp"
#include "dashpad/pad/power_shape.hpp"
#include "dashpad/pad/unloading.hpp"

namespace dashpad {

struct TwentyOneParameter {
  double asymptotic_modulus = 0;        ///< E_inf, Pa, > 0
  double contact_exponent = 0;          ///< m, in (0, 1]
  double compaction_exponent = 0;       ///< n, in [0, 4]
  double relaxation_exponent = 0;       ///< a, in (0, 1]
  double relaxation_scale = 0;          ///< b, s^a, > 0
  double relaxation_strain_base = 0;    ///< c, > 0
  double rate_stress = 0;               ///< S_r, Pa at 1/s, >= 0
  double rate_exponent = 0;             ///< R, in (0, 1]
  double rate_strain_exponent = 0;      ///< U, in (0, 10]
  double rate_strain_scale = 0;         ///< V, > 0
  double growth_strain_exponent = 0;    ///< W, in (m, 10]: no steeper than A at first contact
  double growth_strain_scale = 0;       ///< X, >= 0.01
  double onset_strain_exponent = 0;     ///< Y, in (m, 10]: likewise
  double onset_strain_scale = 0;        ///< Z, > 0
  double residual_strain_time = 0;      ///< tau*, s, > 0
  double residual_strain_exponent = 0;  ///< p, in (0, 1]

  static constexpr const char* name = "twenty-one-parameter";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<TwentyOneParameter>, 16> parameters;

  struct StrainPart {
    double lasting = 0;    ///< E_inf A
    double sensitive = 0;  ///< S_r (exp(e^W/X) - exp(-e^Y/Z))
    double exponent = 0;   ///< R exp(-e^U/V)
  };
  struct RatePart {
    double log_rate = 0;
    double residual_ratio = 0;
    bool still = true;
    bool unloading = false;
  };
  struct TimePart {
    double scale = 0;     ///< (t1^a - t0^a) / b
    double centre = 0;    ///< where in the step h has its centre of gravity, 0 to 1
    double log_base = 0;  ///< ln c
  };

  [[nodiscard]] PowerExponents exponents() const { return {contact_exponent, compaction_exponent}; }
  [[nodiscard]] StrainPart strain_part(Strain strain, const PowerShape::Value& power) const {
    if (strain.value <= 0) return {0, 0, rate_exponent};
    const double u = std::exp(rate_strain_exponent * power.log_strain);
    const double w = std::exp(growth_strain_exponent * power.log_strain);
    const double y = std::exp(onset_strain_exponent * power.log_strain);
    return {asymptotic_modulus * power.shape,
            rate_stress * (std::exp(w / growth_strain_scale) - std::exp(-y / onset_strain_scale)),
            rate_exponent * std::exp(-u / rate_strain_scale)};
  }
  [[nodiscard]] RatePart rate_part(double rate) const {
    if (rate == 0) return {};
    RatePart part{std::log(std::abs(rate)), 0, false, rate < 0};
    if (part.unloading)
      part.residual_ratio = residual_ratio(part.log_rate, residual_strain_time, residual_strain_exponent);
    return part;
  }
  [[nodiscard]] double envelope(StrainPart part, RatePart rate, double strain, double largest_strain) const {
    if (rate.still) return part.lasting;
    const double loading = part.lasting + part.sensitive * std::exp(part.exponent * rate.log_rate);
    return rate.unloading && strain > 0
               ? loading * unloading_factor(strain, largest_strain, rate.residual_ratio)
               : loading;
  }
  /// dG/de with rate and largest strain held. With S = S_r (exp(w) - exp(-y)), w = e^W/X, y = e^Y/Z,
  /// k = R exp(-u), u = e^U/V and r = |de/dt|, on loading
  ///
  ///   dG/de = E_inf A' + r^k (S_r (W w exp(w) + Y y exp(-y)) - S U u k ln r) / e
  ///
  /// and by the product rule with E on unloading. Strain > 0.
  [[nodiscard]] double envelope_slope(Strain strain, const PowerShape& power, RatePart rate,
                                      double largest_strain) const {
    const auto at = power.at(strain);
    const StrainPart part = strain_part(strain, at);
    const double lasting_slope = part.lasting * power.log_slope(strain);
    if (rate.still) return lasting_slope;
    const double u = std::exp(rate_strain_exponent * at.log_strain) / rate_strain_scale;
    const double w = std::exp(growth_strain_exponent * at.log_strain) / growth_strain_scale;
    const double y = std::exp(onset_strain_exponent * at.log_strain) / onset_strain_scale;
    const double growth =
        rate_stress * (growth_strain_exponent * w * std::exp(w) + onset_strain_exponent * y * std::exp(-y));
    const double fading = part.sensitive * rate_strain_exponent * u * part.exponent * rate.log_rate;
    const double power_of_rate = std::exp(part.exponent * rate.log_rate);
    const double slope = lasting_slope + power_of_rate * (growth - fading) / strain.value;
    if (!rate.unloading) return slope;
    const double value = part.lasting + part.sensitive * power_of_rate;
    return slope * unloading_factor(strain.value, largest_strain, rate.residual_ratio) +
           value * unloading_factor_slope(strain.value, largest_strain, rate.residual_ratio);
  }
  /// 0 <= from < to.
  [[nodiscard]] TimePart time_part(double from, double to) const {
    const double a = relaxation_exponent;
    const double early = std::pow(from, a);
    const double late = std::pow(to, a);
    const double step = to - from;
    // First moment of t^(a-1) about the start of the step; a small step is as good as its middle.
    double centre = 0.5;
    if (step > 1e-4 * to)
      centre = ((late * to - early * from) * a / ((a + 1) * (late - early)) - from) / step;
    return {(late - early) / relaxation_scale, centre, std::log(relaxation_strain_base)};
  }
  [[nodiscard]] double decay(TimePart time, double strain_from, double strain_to, double) const {
    const double strain = strain_from + time.centre * (strain_to - strain_from);
    return std::exp(-time.scale * std::exp(-time.log_base * strain));
  }
  [[nodiscard]] double relaxation_rate(double time, double strain) const {
    return relaxation_exponent * std::pow(time, relaxation_exponent - 1) /
           (relaxation_scale * std::pow(relaxation_strain_base, strain));
  }
  [[nodiscard]] double edge_ratio(RatePart) const { return asymptotic_modulus; }
};

inline constexpr std::array<Parameter<TwentyOneParameter>, 16> TwentyOneParameter::parameters{{
    {"asymptotic_modulus", "E_inf", "Pa", &TwentyOneParameter::asymptotic_modulus, positive,
     "modulus of the lasting stress"},
    {"contact_exponent", "m", "1", &TwentyOneParameter::contact_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true}, "exponent of the strain"},
    {"compaction_exponent", "n", "1", &TwentyOneParameter::compaction_exponent,
     Bounds{.lowest = 0, .highest = 4, .lowest_admitted = true, .highest_admitted = true},
     "exponent of one minus the strain"},
    {"relaxation_exponent", "a", "1", &TwentyOneParameter::relaxation_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true}, "exponent of time in the relaxation"},
    {"relaxation_scale", "b", "1", &TwentyOneParameter::relaxation_scale, positive,
     "scale of the relaxation, with time in seconds"},
    {"relaxation_strain_base", "c", "1", &TwentyOneParameter::relaxation_strain_base,
     Bounds{.lowest = 1e-3, .highest = 1e3, .lowest_admitted = true, .highest_admitted = true},
     "base of the strain's effect on the relaxation"},
    {"rate_stress", "S_r", "Pa", &TwentyOneParameter::rate_stress, not_negative,
     "stress that a strain rate of 1/s adds"},
    {"rate_exponent", "R", "1", &TwentyOneParameter::rate_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true},
     "exponent of the strain rate at small strain"},
    {"rate_strain_exponent", "U", "1", &TwentyOneParameter::rate_strain_exponent,
     Bounds{.lowest = 0, .highest = 10, .highest_admitted = true}, "how the rate exponent falls with strain"},
    {"rate_strain_scale", "V", "1", &TwentyOneParameter::rate_strain_scale, positive, "its scale"},
    {"growth_strain_exponent", "W", "1", &TwentyOneParameter::growth_strain_exponent,
     Bounds{.lowest = 0, .highest = 10, .highest_admitted = true}, "how the rate stress grows with strain"},
    {"growth_strain_scale", "X", "1", &TwentyOneParameter::growth_strain_scale,
     Bounds{.lowest = 0.01, .lowest_admitted = true}, "its scale"},
    {"onset_strain_exponent", "Y", "1", &TwentyOneParameter::onset_strain_exponent,
     Bounds{.lowest = 0, .highest = 10, .highest_admitted = true},
     "how the rate stress sets in at small strain"},
    {"onset_strain_scale", "Z", "1", &TwentyOneParameter::onset_strain_scale, positive, "its scale"},
    {"residual_strain_time", "tau*", "s", &TwentyOneParameter::residual_strain_time, positive,
     "scale of the strain rate in the residual strain on unloading"},
    {"residual_strain_exponent", "p", "1", &TwentyOneParameter::residual_strain_exponent,
     Bounds{.lowest = 0, .highest = 1, .highest_admitted = true}, "its exponent"},
}};

}  // namespace dashpad
