#pragma once
/// An impact that leaves much uncertain: a foam tested less far than it is compressed.

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::test {

inline Foam foam_of_pillar() {
  Foam of;
  of.unloading_factor = 0;
  of.unloading_shape = 1.5;
  of.curves = {.base = AvalleCurve{.plateau_stress = 222e3,
                                   .modulus = 6.3e6,
                                   .plateau_exponent = 1,
                                   .densification_stress = 108e3,
                                   .densification_exponent = 1.31,
                                   .highest_strain = 0.75},
               .slowest_rate = 0.01,
               .rate_effect = PowerRateEffect{.exponent = 0.04, .exponent_slope = 0, .highest_rate = 100}};
  return of;
}

/// A head on a trim of 25 mm: beyond a strain of 0.75 and a rate of 100 per second.
inline ImpactCase head_on_pillar() {
  ImpactCase impact;
  impact.impactor = {.mass = 4.54, .nose = Sphere{0.08}, .speed = 6.7056};
  impact.pad.thickness = 0.025;
  impact.pad.material.name = "made up";
  impact.pad.material.law = foam_of_pillar();
  impact.support = Support::linear(300e3);
  return impact;
}

}  // namespace dashpad::test
