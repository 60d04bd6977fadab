#pragma once
/// The nose radius of the projectiles is lost. Which one do the measurements favour, and how firmly?

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation/simulations.hpp"
#include "dashpad/report1986/validation/trends.hpp"

namespace dashpad::report1986 {

inline constexpr double least_radius_in = 1.5;
inline constexpr double greatest_radius_in = 4;

/// 1.5 to 4 in, in steps of 0.25 in.
std::vector<double> radii_of_the_study();

/// A criterion's misfit over the radius: root mean square of the residuals.
struct RadiusCriterion {
  std::string name = {};            ///< "strains on the plate", "forces on the load cell", ...
  std::string remark = {};          ///< which tests, which program
  std::string unit = {};            ///< of the misfit
  std::vector<double> misfit = {};  ///< one for each radius of the study; NaN where a run has no figure
  double favoured_in =
      0;  ///< least misfit, by a parabola through three radii, to 0.01 in; NaN without any misfit
  /// The least misfit is at an end of the range, or of its radii with a figure: a bound, no estimate.
  bool at_an_end = false;
  /// Radii whose misfit is not significantly larger (95 %, F test with one parameter; the whole range where
  /// the data cannot tell).
  Interval admitted = {};
  int readings = 0;
  bool of_the_report = false;  ///< its statements on its own simulations, by the program that it used
};

/// The criterion whose residuals at a radius are `residuals_at(radius)`, one a reading; absent: no figure.
RadiusCriterion radius_criterion(
    std::string name, std::string remark, std::string unit,
    const std::function<std::vector<std::optional<double>>(double radius_in)>& residuals_at);

struct RadiusStudy {
  std::vector<double> radii_in;
  /// The first decides: strains of the plate tests 25 to 27 by the accurate solver, independent of the
  /// reconstructed load-cell curve. The others are shown beside it: curve "B" on the plate (the report's
  /// estimate, not a measurement), forces, times and strains on the load cell by the accurate solver; and the
  /// report's own statements about its simulations (section 4: ratios to the trend 1 to 0.4 and 1.4 to 0.4;
  /// times to peak 2 ms above VT = 1.25 in; agreement with curve "B" on the plate) by the program of 1984,
  /// which tells the radius that the report used, and the first two by the accurate solver with the first
  /// slope. Statements are no readings: there the 95 % range only ranks radii.
  std::vector<RadiusCriterion> criteria;
  [[nodiscard]] double favoured_in() const { return criteria.front().favoured_in; }
  /// The radius of the study next to the one that the report simulated with: the mean of its statements'
  /// favoured radii without the bounds, an inference. favoured_in() where they give no estimate.
  [[nodiscard]] double of_the_report_in() const;
};

/// What the criteria ask for besides predictions of the tests at all radii.
std::vector<Prediction> predict_for_radius(const ValidationData& data, const Material& ensolite,
                                           const Progress& progress = {});

/// From `at_tests`: every test at every radius of the study by the accurate solver, and `others` of
/// predict_for_radius().
RadiusStudy study_radius(const ValidationData& data, const std::vector<Prediction>& at_tests,
                         const std::vector<Prediction>& others);

}  // namespace dashpad::report1986
