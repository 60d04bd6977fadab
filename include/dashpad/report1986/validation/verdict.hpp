#pragma once
/// Errors of the predictions in the measured tests, and the rules that were fixed before the model was run
/// (docs/decisions/0007-validation-rules.md).

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation/simulations.hpp"
#include "dashpad/report1986/validation/trends.hpp"

namespace dashpad::report1986 {

enum class Quantity { peak_force, time_to_peak, rebound_speed, peak_strain };
inline constexpr Quantity quantities[] = {Quantity::peak_force, Quantity::time_to_peak,
                                          Quantity::rebound_speed, Quantity::peak_strain};
const char* to_string(Quantity quantity);
/// "Peak force (lb)".
std::string axis_label(Quantity quantity);
/// The value with as many digits as a reading of the quantity has.
std::string with_digits(double value, Quantity quantity);

/// The measured value, if it is certain, and the predicted value of a quantity.
std::optional<double> measured(const MeasuredTest& test, Quantity quantity);
std::optional<double> predicted(const Prediction& prediction, Quantity quantity);
/// The value that a program predicts for a setup.
std::optional<double> predicted(const std::vector<Prediction>& predictions, Program program,
                                const Setup& setup, Quantity quantity);

/// The rule of a quantity: bounds of bias and scatter of ln(predicted/measured); for strain, the difference.
struct Rule {
  Quantity quantity;
  double low = 0, high = 0, scatter = 0;
  bool logarithmic = true;
};
extern const std::array<Rule, 4> rules;
const Rule& rule_of(Quantity quantity);

/// ln(predicted/measured), or the difference for strain.
double error_of(const Rule& rule, double measured, double predicted);

/// The error of one test.
struct TestError {
  int test = 0;
  double measured = 0, predicted = 0;
  double error = 0;  ///< predicted/measured - 1, or the difference for strain
};
TestError test_error(const Rule& rule, int test, double measured, double predicted);

/// Statistics of the errors of a score, as error_of() gives them.
struct Statistics {
  double bias = 0;      ///< exp(mean) - 1, or the mean
  double scatter = 0;   ///< standard deviation, n - 1; 0 for fewer than two
  bool passed = false;  ///< false for fewer than two
};
Statistics judge(const Rule& rule, const std::vector<double>& errors);
Statistics statistics_of(const Rule& rule, const std::vector<TestError>& errors);

/// A program on a support, for one quantity, at one radius.
struct Score {
  Program program = Program::accurate;
  TestSupport support = TestSupport::load_cell;
  Quantity quantity = Quantity::peak_force;
  double radius_in = 0;
  std::optional<Projectile> projectile = {};  ///< absent for both
  std::vector<TestError> errors = {};         ///< of the tests with a certain reading and a prediction
  int missing = 0;                            ///< number of tests with a certain reading, but no prediction
  double bias = 0;                            ///< exp(mean of ln ratio) - 1, or mean difference
  double scatter = 0;  ///< standard deviation of ln ratio, or of the difference; 0 for fewer than two tests
  /// Whether the rule is met and no prediction is missing: a program cannot pass by ending in an ABEND.
  bool passed = false;
};

Score score(const MeasuredTests& measured, const std::vector<Prediction>& predictions, Program program,
            TestSupport support, Quantity quantity, double radius_in,
            std::optional<Projectile> projectile = {});

/// A score of readings whose tests are lost, over all placings in their order. The rules count certain
/// readings only; this is shown beside the verdicts.
struct PlacedScore {
  Program program = Program::accurate;
  double radius_in = 0;
  UnplacedReadings group;
  Quantity quantity = Quantity::peak_force;
  long placings = 0;         ///< number of those with a prediction for every reading
  long placings_passed = 0;  ///< number of those that would pass
  double bias = 0;           ///< mean over the placings
  Interval bias_over_placings, scatter_over_placings;
};

/// Scores of all groups of the quantities above; strains by the plug and by the diameter are separate.
std::vector<PlacedScore> placed_scores(const MeasuredTests& measured,
                                       const std::vector<Prediction>& predictions, Program program,
                                       double radius_in);

/// The second rule of the rebound speed: the prediction must lie between the measured speed and the bound of
/// the report's Table 3-2.
struct Admissible {
  Program program = Program::accurate;
  double radius_in = 0;
  int admissible = 0, tests = 0;
  int too_low = 0, too_high = 0;
  int missing = 0;  ///< tests without a prediction, which are not admissible
  bool passed = false;
};

/// The bound of Table 3-2 for one test, by its own measured rebound and force: sqrt((U_R + W_S)/U) V, mph.
/// Absent without these readings.
std::optional<double> rebound_bound_mph(const ValidationData& data, const MeasuredTest& test);

Admissible admissible_rebounds(const ValidationData& data, const std::vector<Prediction>& predictions,
                               Program program, double radius_in);

/// A score at the favoured radius, and its range over all radii of the study.
struct Verdict {
  Score score;
  Interval bias_over_radii;
  Interval scatter_over_radii;
  int radii_passed = 0, radii = 0;
};

/// The slope of ln(predicted/measured force) over ln(speed) with its 95 % interval, and the ratios to the
/// report's trend at the ends of its speed ranges. NaN if predictions are missing.
struct ForceTrend {
  Program program = Program::accurate;
  double radius_in = 0;
  int tests = 0;     ///< both projectiles, load cell, with force and prediction
  double slope = 0;  ///< one line through all of them
  Interval slope_confidence = {};
  double aluminium_slope = 0;  ///< the aluminium projectile alone; the steel one spans only 1.5 mph
  Interval aluminium_slope_confidence = {};
  double aluminium_low = 0, aluminium_high = 0;  ///< ratio to curve "A" at 10 and 20 mph
  double steel_low = 0, steel_high = 0;          ///< at 10 and 15 mph
};

/// A ratio of forces that the report prints for one end of a speed range (section 4).
struct PrintedRatio {
  Projectile projectile;
  double speed_mph;
  const char* constant;
  double ForceTrend::*ours;
};
inline constexpr PrintedRatio printed_ratios[] = {
    {Projectile::aluminium, 10, "force_ratio_aluminium_low_speed", &ForceTrend::aluminium_low},
    {Projectile::aluminium, 20, "force_ratio_aluminium_high_speed", &ForceTrend::aluminium_high},
    {Projectile::steel, 10, "force_ratio_steel_low_speed", &ForceTrend::steel_low},
    {Projectile::steel, 15, "force_ratio_steel_high_speed", &ForceTrend::steel_high}};

/// Curve "A", lb: the trend of Eq. 36; for the aluminium projectile at least the mean force of tests 1 and
/// 24, through which the report draws the tail (Figure 3-9), since the trend does not hold below 300 in.lb.
double curve_a_force_lb(const ValidationData& data, Projectile projectile, double speed_mph);
/// Curve "B" without a tail, lb.
double curve_b_force_lb(const ValidationData& data, Projectile projectile, double speed_mph);

ForceTrend force_trend(const ValidationData& data, const std::vector<Prediction>& at_tests,
                       const std::vector<Prediction>& on_curves, Program program, double radius_in);

enum class Explanation { explains, in_part, does_not };

struct AnomalyVerdict {
  std::vector<ForceTrend> trends;           ///< one per program, at the favoured radius
  bool first_slope_gives_the_fall = false;  ///< accurate_first_slope gives the printed ratios
  bool curve_removes_the_fall = false;      ///< accurate has no slope, and its peak forces pass
  bool slope_halves = false;                ///< from accurate_first_slope to accurate
  Explanation explanation = Explanation::does_not;
  std::vector<Explanation> over_radii;  ///< the result at each radius of the study
};

/// `force_passed`: whether the accurate solver passes the peak-force rule on the load cell.
AnomalyVerdict judge_anomaly(const ValidationData& data, std::vector<ForceTrend> trends, bool force_passed);

/// The setups of the tests at a radius, and those of the report's simulations (section 4).
std::vector<Setup> setups_of_tests(const MeasuredTests& measured, double radius_in);
std::vector<Setup> setups_of_curves(double radius_in);

}  // namespace dashpad::report1986
