#pragma once
/// What the laws of subroutine PAD share.
///
/// The empirical laws 4 and 5 work in magnitudes; the stress gets its sign back at the end. They take the
/// strain at the start of the step for A and its slope, and the strain rate of the axis for every station.

#include <array>

#include "spit1984/arithmetic.hpp"
#include "spit1984/contact_field.hpp"

namespace dashpad::spit1984 {

/// PPAR in the arithmetic of the program.
template <class Real>
using PadParameters = std::array<Real, 21>;

/// ISGN: the sign of a stress, negative for none; its sense is that of the strain.
template <class Real>
Real sign_of_stress(Real stress) {
  const Real magnitude = abs(stress);
  if (magnitude == Real(0)) return Real(-1);
  return Real(truncated(Real(1.1) * magnitude / stress));
}

/// EKM: the magnitude of the strain at the start of the step, or half of that at the end where it was zero.
template <class Real>
Real strain_magnitude(const ContactField<Real>& field, int station) {
  const Real magnitude = abs(field.strain[station]);
  return magnitude == Real(0) ? (magnitude + abs(field.new_strain[station])) / Real(2) : magnitude;
}

/// SKP1 from its magnitude's increase; a stress that was tensile stays so.
template <class Real>
void advance_stress(ContactField<Real>& field, int station, Real rate, Real step) {
  const Real sign = sign_of_stress(field.stress[station]);
  const Real stress = sign * (abs(field.stress[station]) + rate * step);
  field.new_stress[station] = sign == Real(1) ? abs(stress) : stress;
}

/// The factor E of the stress on unloading and its rate of change.
template <class Real>
struct Unloading {
  Real factor;  ///< E = (e - e* D) / (e (1 - D)), with D = (tau* |de/dt|)^p
  Real rate;    ///< dE/dt

  Unloading(Real strain, Real largest_strain, Real residual_ratio, Real strain_rate) {
    const Real one(1);
    factor = (strain - largest_strain * residual_ratio) / (strain * (one - residual_ratio));
    rate = strain_rate * largest_strain * residual_ratio / (strain * strain * (one - residual_ratio));
  }
};

}  // namespace dashpad::spit1984
