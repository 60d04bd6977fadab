#pragma once
/// Subroutine PAD, law 2.

#include "spit1984/stress_update.hpp"

namespace dashpad::spit1984 {

/// KEYP = 2.
template <class Real>
Real linear_viscoelastic(const PadParameters<Real>& parameters, ContactField<Real>& field, int stations,
                         Real step) {
  const Real asymptotic = parameters[0], initial = parameters[1], relaxation_time = parameters[2];
  const Real kept = Real(1) - step / relaxation_time;
  const Real released = initial - asymptotic * step / relaxation_time;
  for (int i = 0; i < stations; ++i)
    field.new_stress[i] = kept * field.stress[i] + initial * field.new_strain[i] - released * field.strain[i];
  const Real rate = (field.new_strain[0] - field.strain[0]) / step;
  const Real divisor =
      field.new_stress[0] - initial * relaxation_time * rate - asymptotic * field.new_strain[0];
  return field.new_strain[0] + field.new_stress[0] * relaxation_time * rate / divisor;
}

}  // namespace dashpad::spit1984
