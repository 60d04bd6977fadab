/// A law that only the tests have, to show what a law needs: G = K A(e) on loading and unloading alike, h = 1
/// / tau.
#ifndef DASHPAD_TESTS_POWER_MAXWELL_HPP
#define DASHPAD_TESTS_POWER_MAXWELL_HPP

#include <array>
#include <cmath>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {

struct PowerMaxwell {
  double modulus = 0;              ///< K, Pa
  double contact_exponent = 0;     ///< m
  double compaction_exponent = 0;  ///< n
  double relaxation_time = 0;      ///< tau, s

  static constexpr const char* name = "power-maxwell";
  static constexpr bool memoryless = false;
  static constexpr std::array<Parameter<PowerMaxwell>, 0> parameters{};

  struct RatePart {};
  struct TimePart {
    double decay = 1;
  };
  [[nodiscard]] PowerExponents exponents() const { return {contact_exponent, compaction_exponent}; }
  [[nodiscard]] RatePart rate_part(double) const { return {}; }
  [[nodiscard]] TimePart time_part(double from, double to) const {
    return {std::exp((from - to) / relaxation_time)};
  }
  [[nodiscard]] double relaxation_rate(double) const { return 1 / relaxation_time; }
  [[nodiscard]] double edge_ratio(RatePart) const { return modulus; }
};
static_assert(HasMemory<PowerMaxwell>);

}  // namespace dashpad
#endif

#ifdef DASHPAD_FORMULAS

template <>
struct Formulas<PowerMaxwell> {
  static constexpr std::size_t parts = 1;
  const PowerMaxwell law;
  const PowerShape& power;
  const PowerMaxwell::RatePart rate;
  const PowerMaxwell::TimePart time;

  template <class N>
  DASHPAD_FORMULA Shape<N> strain_part(Strains<N> e, N* part) const {
    const Shape<N> at = shape_at(power, e);
    part[0] = at.shape;
    return at;
  }
  template <class N>
  DASHPAD_FORMULA N envelope(const N* part, N, N) const {
    return law.modulus * part[0];
  }
  template <class N>
  DASHPAD_FORMULA N decay(N, N, N) const {
    return N(time.decay);
  }
};

#endif
