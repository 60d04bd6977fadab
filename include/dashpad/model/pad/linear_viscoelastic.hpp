#ifndef DASHPAD_PAD_LINEAR_VISCOELASTIC_HPP
#define DASHPAD_PAD_LINEAR_VISCOELASTIC_HPP
/// Law 2: linear viscoelastic pad (the standard linear solid).
///
///   G = E_inf e + (E_0 - E_inf) tau de/dt,  h = 1/tau              (theory.md, Eq. 11; report, KEYP = 2)
///
/// Stress and strain are engineering values, compression positive. The law is the same on loading and
/// unloading. E_0 is the modulus under a sudden strain, E_inf that under a lasting one.

#include <array>

#include "dashpad/model/pad/power_shape.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct LinearViscoelastic {
  double asymptotic_modulus = 0;  ///< E_inf, Pa, > 0
  double initial_modulus = 0;     ///< E_0, Pa, >= E_inf
  double relaxation_time = 0;     ///< tau, s, > 0

  static constexpr const char* name = "linear-viscoelastic";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<LinearViscoelastic>, 3> parameters;

  struct RatePart {
    double viscous_stress = 0;  ///< (E_0 - E_inf) tau de/dt
  };
  struct TimePart {
    double duration = 0;  ///< length of the step over tau
  };

  [[nodiscard]] PowerExponents exponents() const { return {1, 0}; }
  [[nodiscard]] RatePart rate_part(double rate) const {
    return {(initial_modulus - asymptotic_modulus) * relaxation_time * rate};
  }
  [[nodiscard]] TimePart time_part(double from, double to) const { return {(to - from) / relaxation_time}; }
  /// h at strain zero, 1/s.
  [[nodiscard]] double relaxation_rate(double) const { return 1 / relaxation_time; }
  /// Limit of stress / A at the contact edge, where the strain has just begun to grow.
  [[nodiscard]] double edge_ratio(RatePart) const { return initial_modulus; }

  friend bool operator==(const LinearViscoelastic&, const LinearViscoelastic&) = default;
};

inline constexpr std::array<Parameter<LinearViscoelastic>, 3> LinearViscoelastic::parameters{{
    {"asymptotic_modulus", "E_inf", "Pa", &LinearViscoelastic::asymptotic_modulus, positive,
     "modulus under a sustained strain"},
    {"initial_modulus", "E_0", "Pa", &LinearViscoelastic::initial_modulus, positive,
     "modulus under a sudden strain, at least asymptotic_modulus"},
    {"relaxation_time", "tau", "s", &LinearViscoelastic::relaxation_time, positive,
     "relaxation time constant"},
}};

}  // namespace dashpad

#endif

#ifdef DASHPAD_FORMULAS  // see src/model/pad/formulas.hpp

template <>
struct Formulas<LinearViscoelastic> {
  static constexpr std::size_t parts = 1;
  const LinearViscoelastic law;
  const PowerShape& power;
  const LinearViscoelastic::RatePart rate;
  const LinearViscoelastic::TimePart time;

  /// part: E_inf e.
  template <class N>
  DASHPAD_FORMULA Shape<N> strain_part(Strains<N> e, N* part) const {
    part[0] = law.asymptotic_modulus * e.value;
    return {e.value, e.value, e.complement};
  }
  template <class N>
  DASHPAD_FORMULA N measure(Strains<N> e, const Shape<N>&) const {
    return 0.5 * e.value * e.value;
  }
  template <class N>
  DASHPAD_FORMULA N envelope(const N* part, N, N) const {
    return part[0] + rate.viscous_stress;
  }
  /// A column that is touched within the step relaxes for its share of the step, since G is not 0 there.
  template <class N>
  DASHPAD_FORMULA N decay(N, N, N share) const {
    return exp(-time.duration * share);
  }
  /// Stress at the end of a step (theory.md, Eq. 9). As the relaxation time grows, G exceeds all stresses by
  /// far; of its viscous part only the product with 1 - exp(-x), x = dt / tau, is formed.
  template <class N>
  DASHPAD_FORMULA N step(N stress, const N* before, const N* after, N share) const {
    const N x = time.duration * share;
    const N decay = this->decay(x, x, share);
    const N series = 1.0 - x * (0.5 - x * (1.0 / 6 - x * (1.0 / 24)));
    const N grown = select(x <= N(2e-3), x * series, 1.0 - decay);
    return (stress - before[0]) * decay + after[0] + rate.viscous_stress * grown;
  }
};

#endif
