#ifndef DASHPAD_PAD_VISCOELASTIC_FOAM_HPP
#define DASHPAD_PAD_VISCOELASTIC_FOAM_HPP
/// Slow foam: a lasting curve of the hyperfoam kind, with one or two Maxwell branches.
///
///   stress = p(e) + q1 + q2,   dq_i/dt = g_i dp/dt - q_i / tau_i                 (theory.md, Eq. 40)
///   p(e)   = sum over j of 2 mu_j / (a_j (1 - e)) (1 - (1 - e)^a_j)
///
/// Over a step in which p changes evenly: q_i1 = q_i0 exp(-H_i) + g_i (p1 - p0) (1 - exp(-H_i)) / H_i, with
/// H_i = step / tau_i. The stress is (1 + g1 + g2) p under a sudden strain and p under a lasting one, on
/// loading and unloading alike. Engineering values, compression positive; times in s.

#include <algorithm>
#include <array>

#include "dashpad/model/pad/power_shape.hpp"
#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct ViscoelasticFoam {
  double first_modulus = 0;    ///< mu_1, Pa, > 0
  double first_exponent = 0;   ///< a_1, [-3, 50], not 0
  double second_modulus = 0;   ///< mu_2, Pa, >= 0
  double second_exponent = 1;  ///< a_2, [-3, 50], not 0
  double first_share = 0;      ///< g_1, [0, 1000]
  double first_time = 0;       ///< tau_1, s, > 0
  double second_share = 0;     ///< g_2, [0, 1000]
  double second_time = 1;      ///< tau_2, s, > 0

  static constexpr const char* name = "viscoelastic-foam";
  static constexpr bool memoryless = false;
  static const std::array<Parameter<ViscoelasticFoam>, 8> parameters;
  friend bool operator==(const ViscoelasticFoam&, const ViscoelasticFoam&) = default;

  struct RatePart {};
  /// Length of a step over both relaxation times, and the share of a stress that is left after it.
  struct TimePart {
    double first = 0;
    double second = 0;
    double first_left = 1;
    double second_left = 1;
  };

  /// p grows like e at first contact, and like 1 / (1 - e) or faster at full compression.
  [[nodiscard]] PowerExponents exponents() const {
    const double steepest = second_modulus > 0 ? std::min(first_exponent, second_exponent) : first_exponent;
    return {1, std::max(1.0, 1 - steepest)};
  }
  [[nodiscard]] RatePart rate_part(double) const { return {}; }
  [[nodiscard]] TimePart time_part(double from, double to) const {
    const double first = (to - from) / first_time;
    const double second = (to - from) / second_time;
    return {first, second, portable::exp(-first), portable::exp(-second)};
  }
  /// Relaxation rate of the faster branch, 1/s.
  [[nodiscard]] double relaxation_rate(double) const { return 1 / std::min(first_time, second_time); }
  [[nodiscard]] double edge_ratio(RatePart) const {
    return 2 * (first_modulus + second_modulus) * (1 + first_share + second_share);
  }
};

inline constexpr Bounds viscoelastic_exponents = from_to(-3, 50);
inline constexpr Bounds viscoelastic_shares = from_to(0, 1000);
inline constexpr std::array<Parameter<ViscoelasticFoam>, 8> ViscoelasticFoam::parameters{{
    {"first_modulus", "mu_1", "Pa", &ViscoelasticFoam::first_modulus, positive,
     "modulus of the first term of the equilibrium curve"},
    {"first_exponent", "a_1", "1", &ViscoelasticFoam::first_exponent, viscoelastic_exponents,
     "exponent of the stretch in the first term, not 0"},
    {"second_modulus", "mu_2", "Pa", &ViscoelasticFoam::second_modulus, not_negative,
     "modulus of the second term; 0 for none", LeftOut::as_default},
    {"second_exponent", "a_2", "1", &ViscoelasticFoam::second_exponent, viscoelastic_exponents,
     "exponent of the stretch in the second term, not 0", LeftOut::as_default},
    {"first_share", "g_1", "1", &ViscoelasticFoam::first_share, viscoelastic_shares,
     "ratio of the stress of the first branch to the equilibrium stress under a sudden strain"},
    {"first_time", "tau_1", "s", &ViscoelasticFoam::first_time, positive, "its relaxation time"},
    {"second_share", "g_2", "1", &ViscoelasticFoam::second_share, viscoelastic_shares,
     "the same ratio for the second branch", LeftOut::as_default},
    {"second_time", "tau_2", "s", &ViscoelasticFoam::second_time, positive, "its relaxation time",
     LeftOut::as_default},
}};

}  // namespace dashpad

#endif

#ifdef DASHPAD_FORMULAS  // see src/model/pad/formulas.hpp

template <>
struct Formulas<ViscoelasticFoam> {
  static constexpr std::size_t parts = 3;
  const ViscoelasticFoam law;
  const PowerShape& power;
  const ViscoelasticFoam::RatePart rate;
  const ViscoelasticFoam::TimePart time;

  /// part: p; carry() adds q1 and q2.
  template <class N>
  DASHPAD_FORMULA Shape<N> strain_part(Strains<N> e, N* part) const {
    const Shape<N> at = shape_at(power, e);
    const auto term = [&](double modulus, double exponent) {
      return (2 * modulus / exponent) * ((1.0 - exp(exponent * at.log_complement)) / e.complement);
    };
    part[0] = term(law.first_modulus, law.first_exponent);
    if (law.second_modulus > 0) part[0] = part[0] + term(law.second_modulus, law.second_exponent);
    part[1] = N(0.0);
    part[2] = N(0.0);
    return at;
  }
  /// The lasting stress p.
  template <class N>
  DASHPAD_FORMULA N envelope(const N* part, N, N) const {
    return part[0];
  }
  /// Updates both branches over a step in which the column is in contact for `share`, and returns the stress.
  /// Stress left from an earlier contact relaxes over the whole step.
  template <class N>
  DASHPAD_FORMULA N carry(const N* before, N* part, N share) const {
    const N rise = part[0] - before[0];
    part[1] = before[1] * time.first_left + risen(law.first_share, time.first * share, rise);
    part[2] = before[2] * time.second_left + risen(law.second_share, time.second * share, rise);
    return part[0] + part[1] + part[2];
  }
  /// Lets the branches of a column without strain relax for `share` of a step.
  template <class N>
  [[gnu::always_inline]] inline void relax(N* part, N share) const {
    part[1] = part[1] * exp(-time.first * share);
    part[2] = part[2] * exp(-time.second * share);
  }
  /// Rate of the stress while the strain is held, Pa/s.
  template <class N>
  DASHPAD_FORMULA N relaxing(const N* part) const {
    return (-1 / law.first_time) * part[1] - (1 / law.second_time) * part[2];
  }

 private:
  template <class N>
  DASHPAD_FORMULA N risen(double stiffness, N steps, N rise) const {
    const N least(1e-8);
    // (1 - exp(-H)) / H, by its series where H is tiny.
    const N mean = select(steps < least, 1.0 - 0.5 * steps, (1.0 - exp(N(0.0) - steps)) / max(steps, least));
    return stiffness * (rise * mean);
  }
};

#endif
