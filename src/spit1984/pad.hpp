#pragma once
/// Subroutine PAD: the stresses at the end of a trial step, by a first forward difference of the pad's law
/// (report, Eq. 16):
///
///   S(k+1) = S(k) + f(e(k), de/dt, S(k)) dt
///
/// The empirical laws 4 and 5 work with magnitudes and restore the sign of the stress at the end. They take
/// the strain at the start of the step for A and its slope, and the strain rate of the axis for every
/// station.

#include <array>
#include <cstddef>
#include <vector>

#include "dashpad/spit1984/deck.hpp"
#include "spit1984/arithmetic.hpp"

namespace dashpad::spit1984 {

/// The integration stations of the contact, with their names in the listing. Station 0 is the axis. Strain
/// and stress are negative in compression, as in the listing; the largest strain is a magnitude.
template <class Real>
struct ContactField {
  std::vector<Real> radius;          ///< R, in
  std::vector<Real> strain;          ///< EK, at the start of the step
  std::vector<Real> new_strain;      ///< EKP1, at the end of the trial step
  std::vector<Real> largest_strain;  ///< EMAX
  std::vector<Real> stress;          ///< SK, psi
  std::vector<Real> new_stress;      ///< SKP1, psi

  /// All values start at zero, like the program's memory. There is one station more than the dimension,
  /// because label 190 reads R(2) even for a contact of one station.
  explicit ContactField(std::size_t dimension) {
    for (std::vector<Real>* const column :
         {&radius, &strain, &new_strain, &largest_strain, &stress, &new_stress})
      column->resize(dimension + 1);
  }

  /// 250: makes the strain and stress of the trial those of the step.
  void accept(int station) {
    strain[station] = new_strain[station];
    const Real magnitude = abs(strain[station]);
    if (largest_strain[station] < magnitude) largest_strain[station] = magnitude;
    stress[station] = new_stress[station];
  }
};

/// PPAR in the arithmetic of the program.
template <class Real>
using PadParameters = std::array<Real, 21>;
template <class Real>
PadParameters<Real> converted(const std::array<double, 21>& typed) {
  PadParameters<Real> parameters;
  for (std::size_t i = 0; i < typed.size(); ++i) parameters[i] = static_cast<Real>(typed[i]);
  return parameters;
}

/// ISGN: the sign of a stress as that of a strain; negative for zero.
template <class Real>
Real sign_of_stress(Real stress) {
  const Real magnitude = abs(stress);
  if (magnitude == Real(0)) return Real(-1);
  return Real(truncated(Real(1.1) * magnitude / stress));
}

/// EKM: the magnitude of the strain at the start of the step; if that is zero, half of that at the end.
template <class Real>
Real strain_magnitude(const ContactField<Real>& field, int station) {
  const Real magnitude = abs(field.strain[station]);
  return magnitude == Real(0) ? (magnitude + abs(field.new_strain[station])) / Real(2) : magnitude;
}

/// Sets SKP1 from the increase of its magnitude. A tensile stress stays tensile.
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

/// KEYP = 1.
template <class Real>
Real elastic(const PadParameters<Real>& parameters, ContactField<Real>& field, int stations) {
  for (int i = 0; i < stations; ++i) field.new_stress[i] = parameters[0] * field.new_strain[i];
  return Real(0);
}

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

/// KEYP = 4. Returns `time` if there is no station inside the edge.
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

/// KEYP = 5. Returns `time` if there is no station inside the edge.
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

/// Computes the new stresses of the first `stations` stations. `time` is that of the end of the step, s.
/// Returns the residual strain on the axis, projected from the present rate (the argument TIME on return).
template <class Real>
Real update_stresses(PadKey key, const PadParameters<Real>& parameters, ContactField<Real>& field,
                     int stations, Real step, Real time) {
  switch (key) {
    case PadKey::elastic: return elastic(parameters, field, stations);
    case PadKey::linear_viscoelastic: return linear_viscoelastic(parameters, field, stations, step);
    case PadKey::rigid_foam: return rigid_foam(parameters, field, stations);
    case PadKey::nine_parameter: return nine_parameter(parameters, field, stations, step, time);
    case PadKey::twenty_one_parameter: return twenty_one_parameter(parameters, field, stations, step, time);
  }
  return time;
}

}  // namespace dashpad::spit1984
