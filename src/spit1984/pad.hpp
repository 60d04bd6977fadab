#pragma once
/// Subroutine PAD: the stresses at the end of a trial step, by a first forward difference of the pad's law.
///
///   S(k+1) = S(k) + f(e(k), de/dt, S(k)) dt                                                (report, Eq. 16)

#include "dashpad/spit1984/deck.hpp"
#include "spit1984/elastic.hpp"
#include "spit1984/linear_viscoelastic.hpp"
#include "spit1984/nine_parameter.hpp"
#include "spit1984/rigid_foam.hpp"
#include "spit1984/twenty_one_parameter.hpp"

namespace dashpad::spit1984 {

/// Writes the new stresses of the first `stations` stations. `time` is that of the end of the step, s.
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
