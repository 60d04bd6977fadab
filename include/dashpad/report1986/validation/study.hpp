#pragma once
/// The study on the report's 33 tests.

#include "dashpad/report1986/validation/held_out.hpp"
#include "dashpad/report1986/validation/verdict.hpp"

namespace dashpad::report1986 {

/// The whole study: data in, conclusions out.
struct Study {
  ValidationData data;
  std::vector<FittedConstant> constants;
  NominalStressFit nominal_stress;
  RadiusStudy radius;
  std::vector<Prediction>
      at_tests;  ///< every test, every program, every radius of the study and the favoured one
  std::vector<Prediction>
      on_curves;  ///< the report's speeds (section 4), least, favoured and greatest radius, and the report's
  std::vector<Verdict> verdicts;  ///< program by support by quantity, where anything was measured
  std::vector<Verdict> at_the_reports_radius;  ///< the same at the radius that the report simulated with
  std::vector<Verdict> by_projectile;          ///< on the load cell, for each projectile alone
  std::vector<PlacedScore> placed;             ///< at the favoured radius
  std::vector<Admissible> rebounds;            ///< load cell, at the favoured radius, one a program
  AnomalyVerdict anomaly;
  AnomalyVerdict anomaly_at_the_reports_radius;
  HeldOut held_out;
};

/// `progress` is told of each stage on its own.
Study run_study(const ValidationData& data, const Material& ensolite, const Progress& progress = {});

}  // namespace dashpad::report1986
