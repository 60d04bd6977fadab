#pragma once
/// A small validation study with values that are easy to recognise. Nothing of it was measured or computed.

#include "dashpad/report1986/validation/study.hpp"

namespace dashpad::test {

namespace v = dashpad::report1986;

constexpr double made_up_radius = 2.5;

inline v::ValidationData made_up_data() {
  using enum v::Projectile;
  using enum v::TestSupport;
  v::ValidationData data;
  data.measured.tests = {{.number = 1,
                          .projectile = aluminium,
                          .weight_lb = 4,
                          .support = load_cell,
                          .speed_mph = 12,
                          .energy_in_lb = 230,
                          .rebound_mph = 5,
                          .time_to_peak_ms = 7,
                          .peak_force_lb = 500},
                         {.number = 24,
                          .projectile = aluminium,
                          .weight_lb = 4,
                          .support = load_cell,
                          .speed_mph = 18,
                          .energy_in_lb = 520,
                          .rebound_mph = 8,
                          .time_to_peak_ms = 5,
                          .peak_force_lb = 3000},
                         {.number = 3,
                          .projectile = aluminium,
                          .weight_lb = 4,
                          .support = plate,
                          .speed_mph = 16,
                          .energy_in_lb = 410,
                          .rebound_mph = 9.5,
                          .plug_strain = 0.82},
                         {.number = 4,
                          .projectile = steel,
                          .weight_lb = 8,
                          .support = load_cell,
                          .speed_mph = 14.5,
                          .energy_in_lb = 650,
                          .peak_force_lb = 4000}};
  data.measured.unplaced = {
      {.column = "peak_force_lb", .first_test = 1, .last_test = 2, .readings = {686, 636}}};
  data.load_cell = {{0.1, 900}, {0.2, 9900}};
  data.plate_stiffness_lb_per_in = 5000;
  data.pad_thickness_in = 1.2;
  // The printed constants are the real ones: the claims ask for all of them.
  std::vector<input::Fault> faults;
  data.printed = v::read_validation_data(DASHPAD_SOURCE_DIR "/data/validation", faults).printed;
  data.table_3_2 = {{.projectile = steel, .speed_mph = 14.6, .rebound_mph = 10.4},
                    {.projectile = aluminium, .speed_mph = 12, .rebound_mph = 6}};
  return data;
}

/// Force 100 lb for each mile per hour and inch of radius, in every program twice that of the one before.
inline v::Prediction made_up_prediction(v::Program program, const v::Setup& setup) {
  const double force = 100 * setup.speed_mph * setup.radius_in * (1 << static_cast<int>(program));
  return {.program = program,
          .setup = setup,
          .peak_force_lb = force,
          .time_to_peak_ms = 90 / setup.speed_mph,
          .rebound_mph = setup.speed_mph / 2,
          .peak_strain = 0.9};
}

inline std::vector<v::Prediction> made_up_curves() {
  std::vector<v::Prediction> all;
  for (const v::Program program : v::programs)
    for (const v::Projectile projectile : {v::Projectile::aluminium, v::Projectile::steel})
      for (const v::TestSupport support : {v::TestSupport::load_cell, v::TestSupport::plate})
        for (const double speed : {10., 15., 20.})
          for (const double radius : {1.5, made_up_radius, 4.})
            all.push_back(made_up_prediction(program, {projectile, support, speed, radius}));
  return all;
}

/// Peak forces of tests 1 and 24 on the load cell.
inline v::Verdict made_up_verdict(v::Program program, bool passed) {
  v::Score score{.program = program,
                 .support = v::TestSupport::load_cell,
                 .quantity = v::Quantity::peak_force,
                 .radius_in = made_up_radius,
                 .errors = {{.test = 1, .measured = 500, .predicted = 600, .error = 0.2},
                            {.test = 24, .measured = 3000, .predicted = 1500, .error = -0.5}},
                 .missing = 1,
                 .bias = -0.125,
                 .scatter = 0.25,
                 .passed = passed};
  return {.score = score,
          .bias_over_radii = {-0.2, 0.1},
          .scatter_over_radii = {0.2, 0.3},
          .radii_passed = passed ? 5 : 0,
          .radii = 6};
}

inline v::Study made_up_study() {
  v::Study study;
  study.data = made_up_data();
  study.constants = {{.name = "travel_in",
                      .title = "VT, load cell",
                      .unit = "in",
                      .printed = 1.65,
                      .value = 1.7,
                      .confidence = {1.6, 1.8},
                      .tests = {1, 24},
                      .scatter = 0.3,
                      .residual_unit = "ms",
                      .over_placings = {1.5, 1.9},
                      .placings = 12,
                      .printed_in_confidence = true,
                      .printed_in_placings = true,
                      .method = "least squares"}};
  study.nominal_stress = {.points = {{.test = 1, .stress_psi = 100, .force_lb = 500},
                                     {.test = 0, .stress_psi = 500, .force_lb = 3000}},
                          .area_in2 = 5,
                          .area_over_placings = {4, 7},
                          .scatter = 0.2,
                          .scatter_over_placings = {0.2, 0.4},
                          .slope = 1.1,
                          .slope_confidence = {0.9, 1.3},
                          .remark = "made up"};
  study.radius.radii_in = {1.5, 2, 3, 4};
  study.radius.criteria = {{.name = "strains on the plate",
                            .remark = "test 3",
                            .unit = "1",
                            .misfit = {0.04, 0.02, 0.01, 0.03},
                            .favoured_in = made_up_radius,
                            .admitted = {1.9, 3.8},
                            .readings = 3},
                           {.name = "forces on the load cell",
                            .unit = "1",
                            .misfit = {0.4, 0.3, 0.2, 0.1},
                            .favoured_in = 4,
                            .at_an_end = true,
                            .admitted = {3, 4},
                            .readings = 2}};
  for (const v::MeasuredTest& test : study.data.measured.tests)
    study.at_tests.push_back(made_up_prediction(
        v::Program::accurate, {test.projectile, test.support, test.speed_mph, made_up_radius}));
  study.on_curves = made_up_curves();
  study.verdicts = {made_up_verdict(v::Program::printed_1984, false),
                    made_up_verdict(v::Program::accurate, true)};
  study.at_the_reports_radius = study.verdicts;
  study.rebounds = {{.program = v::Program::accurate,
                     .radius_in = made_up_radius,
                     .admissible = 1,
                     .tests = 2,
                     .too_high = 1}};
  study.anomaly.trends = {{.program = v::Program::printed_1984,
                           .slope = -1.5,
                           .slope_confidence = {-2, -1},
                           .aluminium_low = 1.1,
                           .aluminium_high = 0.5,
                           .steel_low = 1.3,
                           .steel_high = 0.6}};
  study.anomaly.slope_halves = true;
  study.held_out.foam = {.plateau_stress_psi = 43, .densification_exponent = 2.1, .converged = true};
  study.held_out.folds = {{.plateau_stress_psi = 41, .converged = true}, {.plateau_stress_psi = 44}};
  study.held_out.scores = {{.name = "rebound_plate",
                            .support = v::TestSupport::plate,
                            .quantity = v::Quantity::rebound_speed,
                            .errors = {{.test = 3, .measured = 9.5, .predicted = 10.45, .error = 0.1}},
                            .missing = 1,
                            .bias = 0.1}};
  return study;
}

}  // namespace dashpad::test
