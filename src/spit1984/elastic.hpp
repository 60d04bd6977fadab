#pragma once
/// Subroutine PAD, law 1.

#include "spit1984/stress_update.hpp"

namespace dashpad::spit1984 {

/// KEYP = 1.
template <class Real>
Real elastic(const PadParameters<Real>& parameters, ContactField<Real>& field, int stations) {
  for (int i = 0; i < stations; ++i) field.new_stress[i] = parameters[0] * field.new_strain[i];
  return Real(0);
}

}  // namespace dashpad::spit1984
