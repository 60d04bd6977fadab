#pragma once
/// Subroutine PAD, law 3.

#include "spit1984/stress_update.hpp"

namespace dashpad::spit1984 {

/// KEYP = 3. Holds no stress on unloading; beyond the second point the tangent is 9 S2 / (1 - E2).
template <class Real>
Real rigid_foam(const PadParameters<Real>& parameters, ContactField<Real>& field, int stations) {
  const Real crush_stress = parameters[0], crush_strain = parameters[1];
  const Real second_stress = parameters[2], second_strain = parameters[3];
  const Real slope = (second_stress - crush_stress) / (second_strain - crush_strain);
  const Real last_slope = Real(9) * second_stress / (Real(1) - second_strain);
  for (int i = 0; i < stations; ++i) {
    const Real strain = abs(field.new_strain[i]);
    if (field.new_strain[i] - field.strain[i] > Real(0))
      field.new_stress[i] = Real(0);
    else if (strain <= crush_strain)
      field.new_stress[i] = -crush_stress;
    else if (strain <= second_strain)
      field.new_stress[i] = slope * (crush_strain - strain) - crush_stress;
    else
      field.new_stress[i] = last_slope * (second_strain - strain) - second_stress;
  }
  return field.largest_strain[0];
}

}  // namespace dashpad::spit1984
