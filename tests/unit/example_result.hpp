#pragma once
/// A case and a result made by hand, for tests of what is written about them. No solver had a part in it.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::test {

inline ImpactCase example_case() {
  ImpactCase impact;
  impact.title = "Head on a dashboard";
  impact.impactor = {.mass = 4.5, .nose = Sphere{0.0762}, .speed = 8.9408};
  impact.pad.thickness = 0.0254;
  impact.pad.material.name = "soft-foam";
  impact.pad.material.title = "Soft foam";
  impact.pad.material.source = "made up for a test";
  impact.pad.material.law =
      LinearViscoelastic{.asymptotic_modulus = 5e4, .initial_modulus = 2e5, .relaxation_time = 1.0 / 3000};
  impact.pad.material.fitted = FittedRange{.highest_strain = 0.9, .lowest_rate = 1, .highest_rate = 100};
  impact.support = Support::linear(105000);
  return impact;
}

inline Summary example_summary() {
  Summary summary;
  summary.status = Status::released;
  summary.peak_force = 5768.7654321;
  summary.time_of_peak_force = 0.0130234567;
  summary.peak_motion = 0.079965;
  summary.peak_penetration = 0.02032;
  summary.peak_strain = 0.8;
  summary.peak_strain_rate = 312.3;
  summary.peak_acceleration = 130 * standard_gravity;
  summary.force_below_weight = Moment{.time = 0.0241, .velocity = -8.6025};
  summary.contact_end = Moment{.time = 0.0242, .velocity = -8.6030};
  summary.release = Moment{.time = 0.0243, .velocity = -8.6031};
  summary.rebound_speed = 8.6031;
  summary.restitution = 0.96223;
  summary.energy_absorbed_fraction = 0.0741472;
  summary.energy = {.impact = 180, .kinetic = 166, .support = 0, .pad = 13.991, .residual = 0.009};
  summary.errors = {.peak_force = 3e-5,
                    .time_of_peak_force = 2e-5,
                    .peak_motion = 1e-6,
                    .peak_penetration = 3e-6,
                    .rebound_speed = 1e-5,
                    .contact_end = 4e-5,
                    .force_below_weight = 5e-5,
                    .bottomed = 0,
                    .energy_absorbed = 2e-5};
  summary.steps = 240;
  summary.stations = 80;
  summary.runs = 3;
  summary.tolerance = 1e-4;
  summary.wall_time = 8e-4;
  return summary;
}

/// As the solver reports a pad that was fully compressed on a rigid support.
inline Summary bottomed_out_summary() {
  Summary summary = example_summary();
  summary.status = Status::bottomed_out;
  summary.peak_force.reset();
  summary.time_of_peak_force.reset();
  summary.peak_acceleration.reset();
  summary.force_below_weight.reset();
  summary.contact_end.reset();
  summary.release.reset();
  summary.rebound_speed.reset();
  summary.restitution.reset();
  summary.bottomed = Moment{.time = 0.0059307, .velocity = 5.05};
  return summary;
}

}  // namespace dashpad::test
