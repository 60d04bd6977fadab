#ifndef DASHPAD_PAD_NINE_PARAMETER_HPP
#define DASHPAD_PAD_NINE_PARAMETER_HPP
/// Law 4: the report's empirical 9-parameter nonlinear viscoelastic foam.
///
///   loading:   G = A(e) B(de/dt),    A = e^m / (1 - e)^n,   B = E_inf + E_r |de/dt|^r,   h = 1/tau
///   unloading: G = A B E(e, e*, D)
///                                                   (theory.md, Eqs. 14 to 16; report, Eq. 28, KEYP = 4)
///
/// E is in src/model/pad/formulas.hpp, D in dashpad/model/pad/strain.hpp.
///
/// Engineering values, compression positive. |de/dt|^r and (tau* |de/dt|)^p take the rate in 1/s. The ninth
/// parameter, the zero-time modulus E_0, does not enter the law and is left out, as in the 1984 program.

#include <array>
#include <cmath>

#include "dashpad/model/pad/power_shape.hpp"
#include "dashpad/model/pad/strain.hpp"
#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

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

  struct RatePart {
    double modulus = 0;         ///< B
    double residual_ratio = 0;  ///< D, used on unloading
    bool unloading = false;
  };
  struct TimePart {
    double decay = 1;
  };

  [[nodiscard]] PowerExponents exponents() const { return {contact_exponent, compaction_exponent}; }
  [[nodiscard]] RatePart rate_part(double rate) const {
    if (rate == 0) return {asymptotic_modulus, 0, false};
    const double log_rate = portable::log(std::abs(rate));
    RatePart part{asymptotic_modulus + rate_modulus * portable::exp(rate_exponent * log_rate), 0, rate < 0};
    if (part.unloading)
      part.residual_ratio = residual_ratio(log_rate, residual_strain_time, residual_strain_exponent);
    return part;
  }
  [[nodiscard]] TimePart time_part(double from, double to) const {
    return {portable::exp((from - to) / relaxation_time)};
  }
  /// h at strain zero, 1/s.
  [[nodiscard]] double relaxation_rate(double) const { return 1 / relaxation_time; }
  [[nodiscard]] double edge_ratio(RatePart rate) const { return rate.modulus; }
};

inline constexpr std::array<Parameter<NineParameter>, 8> NineParameter::parameters{{
    {"asymptotic_modulus", "E_inf", "Pa", &NineParameter::asymptotic_modulus, positive,
     "modulus of the equilibrium stress"},
    {"contact_exponent", "m", "1", &NineParameter::contact_exponent, above_to(0, 1),
     "exponent of the strain"},
    {"compaction_exponent", "n", "1", &NineParameter::compaction_exponent, from_to(0, 4),
     "exponent of (1 - strain)"},
    {"relaxation_time", "tau", "s", &NineParameter::relaxation_time, positive, "relaxation time constant"},
    {"rate_modulus", "E_r", "Pa", &NineParameter::rate_modulus, not_negative,
     "modulus of the stress added at a strain rate of 1/s"},
    {"rate_exponent", "r", "1", &NineParameter::rate_exponent, above_to(0, 1), "exponent of the strain rate"},
    {"residual_strain_time", "tau*", "s", &NineParameter::residual_strain_time, positive,
     "time that scales the strain rate in the residual strain on unloading"},
    {"residual_strain_exponent", "p", "1", &NineParameter::residual_strain_exponent, above_to(0, 1),
     "exponent of the residual strain"},
}};

}  // namespace dashpad

#endif

#ifdef DASHPAD_FORMULAS  // see src/model/pad/formulas.hpp

template <>
struct Formulas<NineParameter> {
  static constexpr std::size_t parts = 1;
  const NineParameter law;
  const PowerShape& power;
  const NineParameter::RatePart rate;
  const NineParameter::TimePart time;

  /// part: A.
  template <class N>
  DASHPAD_FORMULA Shape<N> strain_part(Strains<N> e, N* part) const {
    const Shape<N> at = shape_at(power, e);
    part[0] = at.shape;
    return at;
  }
  template <class N>
  DASHPAD_FORMULA N envelope(const N* part, N strain, N largest) const {
    return unloaded(part[0] * rate.modulus, rate, strain, largest);
  }
  template <class N>
  DASHPAD_FORMULA N decay(N, N, N) const {
    return N(time.decay);
  }
};

#endif
