#pragma once
/// The study of the report's 33 tests, each of which is also predicted by a foam that was fitted without it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation/verdict.hpp"

namespace dashpad::report1986 {

/// Nose radius, in. The true one is lost; the weights allow at most 2.35 in, and the tests determine only its
/// product with the stress.
inline constexpr double held_out_radius_in = 2;

/// A certain reading of a test.
struct Reading {
  int test = 0;
  Setup setup;  ///< at held_out_radius_in
  Quantity quantity = Quantity::peak_force;
  double value = 0;  ///< in the report's units
};
/// All readings that take part: forces, times and rebound speeds, and the strains on the plate.
std::vector<Reading> certain_readings(const MeasuredTests& measured);

/// The indices of the readings that each fit does not see; each reading is in one fold. On the load cell
/// there are five folds: for each projectile, the rank of the speed modulo five, so that repeated tests stay
/// together. On the plate each test is a fold.
std::vector<std::vector<std::size_t>> folds_of(const std::vector<Reading>& readings);

/// A foam with Avalle's curve (theory.md, Eq. 32): modulus 600 psi, no rate effect, no friction. Its stresses
/// are those at the rates of the tests, 140 to 300 per second.
inline constexpr std::size_t fitted_numbers = 4;
struct FittedFoam {
  double plateau_stress_psi = 0;        ///< A, [0.5, 200]
  double densification_stress_psi = 0;  ///< B, [0.1, 200]
  double densification_exponent = 0;  ///< n, [0.5, 4]; also that of the continuation, where it is at least 1
  double unloading_shape = 0;         ///< SHAPE, [0.02, 50]
  double misfit = 0;                  ///< sum of squared residuals, including those of the priors
  bool converged = false;
  std::string why_not = {};
};
Material material_of(const FittedFoam& foam);

/// Least squares of ln(predicted / measured), or the strains' differences, over decision 16's scatters.
FittedFoam fit_foam(const ValidationData& data, const std::vector<Reading>& readings);

/// A quantity on a support, predicted by fits that have not seen the test. The form of the foam was chosen
/// with all tests in sight, so this is no blind test.
struct HeldOutScore {
  std::string name;  ///< "peak_force", "rebound_plate"
  TestSupport support = TestSupport::load_cell;
  Quantity quantity = Quantity::peak_force;
  std::vector<TestError> errors = {};  ///< as in Score
  int missing = 0;                     ///< tests without a prediction: a fit that did not converge
  double bias = 0;                     ///< exp(mean of ln ratio) - 1, or mean difference
  std::optional<double> standard_error = {},
                        scatter = {};  ///< of the bias, and as in Score; absent below two tests
  bool passed = false;                 ///< by the rules of decision 7
};

struct HeldOut {
  FittedFoam foam;                ///< fitted to all readings
  std::vector<FittedFoam> folds;  ///< as in folds_of()
  std::vector<HeldOutScore> scores;
};

/// Fits on all cores; `progress` is called after each fit.
HeldOut hold_out(const ValidationData& data, const Progress& progress = {});

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

/// `progress` counts each stage separately.
Study run_study(const ValidationData& data, const Material& ensolite, const Progress& progress = {});

}  // namespace dashpad::report1986
