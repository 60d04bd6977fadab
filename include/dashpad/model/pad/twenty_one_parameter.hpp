#ifndef DASHPAD_PAD_TWENTY_ONE_PARAMETER_HPP
#define DASHPAD_PAD_TWENTY_ONE_PARAMETER_HPP
/// Law 5: the report's empirical 21-parameter nonlinear viscoelastic foam.
///
///   loading:   G = E_inf A(e) + S_r |de/dt|^(R exp(-e^U/V)) (exp(e^W/X) - exp(-e^Y/Z))
///   unloading: G = [the same] E(e, e*, D)
///   h = a t^(a-1) / (b c^e)   with t the time since first contact, in s
///                                                (theory.md, Eqs. 14, 16, 17; report, Eq. 28, KEYP = 5)
///
/// E is in src/model/pad/formulas.hpp, D in dashpad/model/pad/strain.hpp.
///
/// Stress and strain are engineering values, compression positive; the rate powers take 1/s. Parameters 17
/// to 21 of the report (the zero-time stress) do not enter the law and are left out, as in the 1984 program.

#include <array>
#include <cmath>

#include "dashpad/model/pad/power_shape.hpp"
#include "dashpad/model/pad/strain.hpp"
#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct TwentyOneParameter {
  double asymptotic_modulus = 0;        ///< E_inf, Pa, > 0
  double contact_exponent = 0;          ///< m, in (0, 1]
  double compaction_exponent = 0;       ///< n, in [0, 4]
  double relaxation_exponent = 0;       ///< a, in (0, 1]
  double relaxation_scale = 0;          ///< b, s^a, > 0
  double relaxation_strain_base = 0;    ///< c, [0.001, 1000]
  double rate_stress = 0;               ///< S_r, Pa at 1/s, >= 0
  double rate_exponent = 0;             ///< R, in (0, 1]
  double rate_strain_exponent = 0;      ///< U, in (0, 10]
  double rate_strain_scale = 0;         ///< V, > 0
  double growth_strain_exponent = 0;    ///< W, in (m, 10]: no steeper than A at first contact
  double growth_strain_scale = 0;       ///< X, >= 0.01
  double onset_strain_exponent = 0;     ///< Y, in (m, 10], as W
  double onset_strain_scale = 0;        ///< Z, > 0
  double residual_strain_time = 0;      ///< tau*, s, > 0
  double residual_strain_exponent = 0;  ///< p, in (0, 1]

  static constexpr const char* name = "twenty-one-parameter";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<TwentyOneParameter>, 16> parameters;

  struct RatePart {
    double log_rate = 0;
    double residual_ratio = 0;
    bool still = true;
    bool unloading = false;
  };
  struct TimePart {
    double scale = 0;   ///< (t1^a - t0^a) / b
    double centre = 0;  ///< centroid of h within the step, 0 to 1
  };

  [[nodiscard]] PowerExponents exponents() const { return {contact_exponent, compaction_exponent}; }
  [[nodiscard]] RatePart rate_part(double rate) const {
    if (rate == 0) return {};
    RatePart part{portable::log(std::abs(rate)), 0, false, rate < 0};
    if (part.unloading)
      part.residual_ratio = residual_ratio(part.log_rate, residual_strain_time, residual_strain_exponent);
    return part;
  }
  /// 0 <= from < to.
  [[nodiscard]] TimePart time_part(double from, double to) const {
    const double a = relaxation_exponent;
    const double early = portable::pow(from, a);
    const double late = portable::pow(to, a);
    const double step = to - from;
    // First moment of t^(a-1) about the start of the step; for a short step the middle is accurate enough.
    double centre = 0.5;
    if (step > 1e-4 * to)
      centre = ((late * to - early * from) * a / ((a + 1) * (late - early)) - from) / step;
    return {(late - early) / relaxation_scale, centre};
  }
  /// h at strain zero, a t^(a-1) / b, 1/s.
  [[nodiscard]] double relaxation_rate(double time) const {
    return relaxation_exponent * portable::pow(time, relaxation_exponent - 1) / relaxation_scale;
  }
  [[nodiscard]] double edge_ratio(RatePart) const { return asymptotic_modulus; }
};

inline constexpr std::array<Parameter<TwentyOneParameter>, 16> TwentyOneParameter::parameters{{
    {"asymptotic_modulus", "E_inf", "Pa", &TwentyOneParameter::asymptotic_modulus, positive,
     "modulus of the equilibrium stress"},
    {"contact_exponent", "m", "1", &TwentyOneParameter::contact_exponent, above_to(0, 1),
     "exponent of the strain"},
    {"compaction_exponent", "n", "1", &TwentyOneParameter::compaction_exponent, from_to(0, 4),
     "exponent of (1 - strain)"},
    {"relaxation_exponent", "a", "1", &TwentyOneParameter::relaxation_exponent, above_to(0, 1),
     "exponent of time in relaxation"},
    {"relaxation_scale", "b", "1", &TwentyOneParameter::relaxation_scale, positive,
     "scale of relaxation, with time in seconds"},
    {"relaxation_strain_base", "c", "1", &TwentyOneParameter::relaxation_strain_base, from_to(1e-3, 1e3),
     "base of the exponential effect of strain on relaxation"},
    {"rate_stress", "S_r", "Pa", &TwentyOneParameter::rate_stress, not_negative,
     "stress added at a strain rate of 1/s"},
    {"rate_exponent", "R", "1", &TwentyOneParameter::rate_exponent, above_to(0, 1),
     "exponent of the strain rate at small strains"},
    {"rate_strain_exponent", "U", "1", &TwentyOneParameter::rate_strain_exponent, above_to(0, 10),
     "exponent of strain in the decrease of the rate exponent"},
    {"rate_strain_scale", "V", "1", &TwentyOneParameter::rate_strain_scale, positive, "its scale"},
    {"growth_strain_exponent", "W", "1", &TwentyOneParameter::growth_strain_exponent, above_to(0, 10),
     "exponent of strain in the growth of the rate stress"},
    {"growth_strain_scale", "X", "1", &TwentyOneParameter::growth_strain_scale,
     Bounds{.lowest = 0.01, .lowest_admitted = true}, "its scale"},
    {"onset_strain_exponent", "Y", "1", &TwentyOneParameter::onset_strain_exponent, above_to(0, 10),
     "exponent of strain in the onset of the rate stress"},
    {"onset_strain_scale", "Z", "1", &TwentyOneParameter::onset_strain_scale, positive, "its scale"},
    {"residual_strain_time", "tau*", "s", &TwentyOneParameter::residual_strain_time, positive,
     "time that scales the strain rate in the residual strain on unloading"},
    {"residual_strain_exponent", "p", "1", &TwentyOneParameter::residual_strain_exponent, above_to(0, 1),
     "exponent of the residual strain"},
}};

}  // namespace dashpad

#endif

#ifdef DASHPAD_FORMULAS  // see src/model/pad/formulas.hpp

template <>
struct Formulas<TwentyOneParameter> {
  static constexpr std::size_t parts = 3;
  const TwentyOneParameter law;
  const PowerShape& power;
  const TwentyOneParameter::RatePart rate;
  const TwentyOneParameter::TimePart time;
  const double log_base = portable::log(law.relaxation_strain_base);  ///< ln c

  /// part: E_inf A, S_r (exp(e^W/X) - exp(-e^Y/Z)), R exp(-e^U/V).
  template <class N>
  DASHPAD_FORMULA Shape<N> strain_part(Strains<N> e, N* part) const {
    const Shape<N> at = shape_at(power, e);
    const N u = exp(law.rate_strain_exponent * at.log_strain);
    const N w = exp(law.growth_strain_exponent * at.log_strain);
    const N y = exp(law.onset_strain_exponent * at.log_strain);
    part[0] = law.asymptotic_modulus * at.shape;
    part[1] = law.rate_stress * (exp(1 / law.growth_strain_scale * w) - exp(-1 / law.onset_strain_scale * y));
    part[2] = law.rate_exponent * exp(-1 / law.rate_strain_scale * u);
    return at;
  }
  template <class N>
  DASHPAD_FORMULA N envelope(const N* part, N strain, N largest) const {
    if (rate.still) return part[0];
    return unloaded(part[0] + part[1] * exp(part[2] * rate.log_rate), rate, strain, largest);
  }
  template <class N>
  DASHPAD_FORMULA N decay(N before, N after, N) const {
    return exp(-time.scale * relaxation(before + time.centre * (after - before)));
  }
  /// c^-e.
  template <class N>
  DASHPAD_FORMULA N relaxation(N strain) const {
    return exp(-log_base * strain);
  }
};

#endif
