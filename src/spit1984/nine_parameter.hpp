#pragma once
/// Subroutine PAD, law 4.

#include "spit1984/stress_update.hpp"

namespace dashpad::spit1984 {

/// KEYP = 4. `time` comes back where there is no station inside the edge.
template <class Real>
Real nine_parameter(const PadParameters<Real>& parameters, ContactField<Real>& field, int stations, Real step,
                    Real time) {
  const int last = stations - 1;
  if (last <= 0) return time;
  const Real asymptotic = parameters[0], m = parameters[1], n = parameters[2],
             relaxation_time = parameters[3];
  const Real zero(0), one(1);
  const Real rate = (field.strain[0] - field.new_strain[0]) / step;
  const Real residual_ratio = power(parameters[6] * abs(rate), parameters[7]);
  const Real modulus = asymptotic + parameters[4] * power(abs(rate), parameters[5]);
  for (int i = 0; i < last; ++i) {
    const Real strain = strain_magnitude(field, i);
    const Real shape = power(strain, m) / power(one - strain, n);
    const Real slope = (m / strain + n / (one - strain)) * rate + one / relaxation_time;
    Real driving = shape * modulus * slope;
    if (rate < zero) {
      const Unloading<Real> unloading(strain, field.largest_strain[i], residual_ratio, rate);
      driving = shape * modulus * (unloading.rate + unloading.factor * slope);
    }
    advance_stress(field, i, driving - abs(field.stress[i]) / relaxation_time, step);
  }
  field.new_stress[last] = zero;
  return abs(field.largest_strain[0]) * residual_ratio;
}

}  // namespace dashpad::spit1984
