#pragma once
/// The envelope G, its slope and h of a law with memory (theory.md, Eq. 8) for a single column.
///
/// Stresses in Pa, compression positive; rates in 1/s; times in s since first contact.

#include <array>
#include <cstddef>

#include "dashpad/model/pad/law.hpp"
#include "model/pad/scalar.hpp"

namespace dashpad {

namespace scalar {
#include "model/pad/formulas.hpp"
}  // namespace scalar

/// G(e), Pa, given the largest strain e* of the column so far.
template <HasMemory Law>
double envelope(const Law& law, const PowerShape& power, Strain strain, const typename Law::RatePart& rate,
                double largest) {
  using Formulas = scalar::Formulas<Law>;
  auto at_rate = rate;
  std::array<double, Formulas::parts> part{};
  if (strain.value <= 0) {
    // At strain zero there is no residual strain.
    if constexpr (requires { at_rate.unloading; }) at_rate.unloading = false;
    return Formulas{law, power, at_rate, {}}.envelope(part.data(), 0.0, 0.0);
  }
  const Formulas at{law, power, at_rate, {}};
  static_cast<void>(at.strain_part(scalar::Strains<double>{strain.value, strain.complement}, part.data()));
  return at.envelope(part.data(), strain.value, largest);
}

/// dG/de with the rate and the largest strain held, Pa. Strain > 0.
template <HasMemory Law>
double envelope_slope(const Law& law, const PowerShape& power, Strain strain,
                      const typename Law::RatePart& rate, double largest) {
  using Series = scalar::Series<double>;
  const scalar::Formulas<Law> at{law, power, rate, {}};
  std::array<Series, scalar::Formulas<Law>::parts> part{};
  const scalar::Strains<Series> e{{strain.value, 1, 0}, {strain.complement, -1, 0}};
  static_cast<void>(at.strain_part(e, part.data()));
  return at.envelope(part.data(), e.value, Series(largest)).first;
}

/// h, 1/s.
template <HasMemory Law>
double relaxation_rate(const Law& law, const PowerShape& power, double time, double strain) {
  const scalar::Formulas<Law> at{law, power, {}, {}};
  return law.relaxation_rate(time) * relaxation_of(at, strain);
}

}  // namespace dashpad
