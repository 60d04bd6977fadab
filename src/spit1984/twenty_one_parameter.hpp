#pragma once
/// Subroutine PAD, law 5.

#include "spit1984/stress_update.hpp"

namespace dashpad::spit1984 {

/// KEYP = 5. Likewise.
template <class Real>
Real twenty_one_parameter(const PadParameters<Real>& parameters, ContactField<Real>& field, int stations,
                          Real step, Real time) {
  const int last = stations - 1;
  if (last <= 0) return time;
  const auto& [EI, m, n, a, b, c, SR, R, U, V, W, X, Y, Z, tau, p, SZ, A, B, C, D] = parameters;
  const Real zero(0), one(1), fifty(50);
  const Real rate = (field.strain[0] - field.new_strain[0]) / step;
  const Real residual_ratio = power(tau * abs(rate), p);
  for (int i = 0; i < last; ++i) {
    const Real strain = strain_magnitude(field, i);
    const Real lasting = EI * power(strain, m) / power(one - strain, n);
    const Real relaxation = a * power(time, a - one) / (b * power(c, strain));
    Real driving = ((m / strain + n / (one - strain)) * rate + relaxation) * lasting;
    Real sensitive = zero;
    if (abs(rate) != zero) {
      const Real u = power(strain, U), w = power(strain, W), y = power(strain, Y);
      const Real decline = u / V >= fifty ? zero : exponential(-(u / V));
      const Real growth = exponential(w / X);
      const Real onset = y / Z >= fifty ? zero : exponential(-(y / Z));
      const Real rate_stress = SR * power(abs(rate), R * decline);
      const Real change = rate * (W * w * growth / X + Y * y * onset / Z) / strain;
      const Real fading = rate * R * U * u * decline * logarithm(abs(rate)) / (V * strain);
      driving = driving + rate_stress * (change + (relaxation - fading) * (growth - onset));
      sensitive = rate_stress * (growth - onset);
    }
    if (rate < zero) {
      const Unloading<Real> unloading(strain, field.largest_strain[i], residual_ratio, rate);
      driving = unloading.rate * (lasting + sensitive) + unloading.factor * driving;
    }
    advance_stress(field, i, driving - relaxation * abs(field.stress[i]), step);
  }
  field.new_stress[last] = zero;
  return abs(field.largest_strain[0]) * residual_ratio;
}

}  // namespace dashpad::spit1984
