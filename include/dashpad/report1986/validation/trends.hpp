#pragma once
/// The report's trend lines (section 3.3), refitted to Table 3-1, and the nose radius that it favours.

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/model/pad/material.hpp"
#include "dashpad/report1986/validation/measured_tests.hpp"
#include "dashpad/report1986/validation/simulations.hpp"

namespace dashpad::report1986 {

/// A 95 % interval (Student's t) or a span.
struct Interval {
  double low = 0;
  double high = 0;
  [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
  /// Widens the interval to include a value.
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};
/// The empty interval, to be widened.
inline constexpr Interval nowhere{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};

/// A constant of the report, refitted to the certain rows.
struct FittedConstant {
  std::string name = {};   ///< as in the printed constants
  std::string title = {};  ///< "V T, load cell", for people
  std::string unit = {};
  double printed = 0;
  double value = 0;             ///< least squares over the certain rows
  Interval confidence = {};     ///< 95 % interval of `value`, by the scatter of the rows
  std::vector<int> tests = {};  ///< the certain rows used
  double scatter = 0;           ///< standard deviation of the residuals, in the unit of the fitted quantity
  std::string residual_unit = {};
  /// Range over all placings of the unplaced readings in their order; equal to `value` without such readings.
  Interval over_placings = {};
  /// Union of the 95 % intervals of all placings. The certain rows are no random sample, so this says more
  /// than `confidence` where many readings are lost.
  Interval confidence_over_placings = {};
  long placings = 0;
  bool printed_in_confidence = false;
  bool printed_in_placings = false;
  std::string method = {};  ///< the quantity that is minimised, and over which rows
};

/// Fits VT in T = VT/V (load cell); V_R/V on the load cell, on the plate, and on the plate without the
/// fastest test, as the report does; exponent and factor of U = (factor F)^exponent above 300 in.lb, by
/// regression of ln U on ln F and of ln F on ln U, because the report does not say which it used.
std::vector<FittedConstant> fit_trends(const ValidationData& data);

/// Nominal stress (report, Eq. 33): e^m / (1 - e)^n (E_inf + E_r (V/L)^r), psi, with V/L in 1/s and the
/// strain e in [0, 1). Throws std::invalid_argument if the law is not the 9-parameter law.
double nominal_stress_psi(const Material& ensolite, double peak_strain, double speed_mph,
                          double thickness_in);

/// Nominal stress and peak force of a test, to be fitted by F = area * stress (report, Figure 3-5).
struct NominalStressPoint {
  int test = 0;  ///< 0 if the test of the strain or of the force is uncertain
  double stress_psi = 0;
  double force_lb = 0;
};

/// Results over all placings of strains and forces in their order, since nearly all strains have lost their
/// tests. The bounds are those of the placings, not of an error.
struct NominalStressFit {
  std::vector<NominalStressPoint> points;  ///< in the placing of least scatter about a line of unit slope
  double area_in2 = 0;                     ///< of that placing
  Interval area_over_placings;
  double scatter = 0;  ///< standard deviation of ln(F / stress) in that placing
  /// The range from `scatter` to a bound that no placing exceeds.
  Interval scatter_over_placings;
  double slope = 0;           ///< of ln F over ln stress in that placing, not constrained to 1
  Interval slope_confidence;  ///< 95 %, as if that placing were the true one
  std::string remark;         ///< which readings, how many placings, what cannot be told
};
NominalStressFit fit_nominal_stress(const ValidationData& data, const Material& ensolite);

inline constexpr double min_radius_in = 1.5;
inline constexpr double greatest_radius_in = 4;

/// 1.5 to 4 in, in steps of 0.25 in.
std::vector<double> radii_of_the_study();

/// The misfit of one criterion over the radius: root mean square of the residuals.
struct RadiusCriterion {
  std::string name = {};            ///< "strains on the plate", "forces on the load cell", ...
  std::string remark = {};          ///< which tests, which program
  std::string unit = {};            ///< of the misfit
  std::vector<double> misfit = {};  ///< one for each radius of the study; NaN where a run has no figure
  double favoured_in =
      0;  ///< least misfit, by a parabola through three radii, to 0.01 in; NaN without any misfit
  /// The minimum is at an end of the range, or of the radii with a figure: a bound rather than an estimate.
  bool at_an_end = false;
  /// Radii whose misfit is not significantly larger (95 %, F test with one parameter), perhaps all.
  Interval admitted = {};
  int readings = 0;
  bool of_the_report = false;  ///< a statement of the report, tested with its program
};

/// The criterion with the residuals `residuals_at(radius)`, one per reading; absent if there is no figure.
RadiusCriterion radius_criterion(
    std::string name, std::string remark, std::string unit,
    const std::function<std::vector<std::optional<double>>(double radius_in)>& residuals_at);

struct RadiusStudy {
  std::vector<double> radii_in;
  /// The first criterion decides: strains of the plate tests 25 to 27 by the accurate solver, which do not
  /// depend on the reconstructed load-cell curve. The others, for comparison: curve "B" on the plate (an
  /// estimate of the report); forces, times and strains on the load cell by the accurate solver; and the
  /// report's statements about its own simulations (section 4: ratios to the trend 1 to 0.4 and 1.4 to 0.4;
  /// times to peak 2 ms above VT = 1.25 in; agreement with curve "B"), by the program of 1984, which shows
  /// the radius that the report used, the first two also by the accurate solver with the first slope. For
  /// statements the 95 % range only ranks radii.
  std::vector<RadiusCriterion> criteria;
  [[nodiscard]] double favoured_in() const { return criteria.front().favoured_in; }
  /// The radius of the study nearest to the one that the report probably used: the mean of the radii favoured
  /// by its statements, without bounds. favoured_in() if they give no estimate.
  [[nodiscard]] double of_the_report_in() const;
};

/// The additional predictions that the criteria need.
std::vector<Prediction> predict_for_radius(const ValidationData& data, const Material& ensolite,
                                           const Progress& progress = {});

/// Evaluates the criteria. `at_tests`: every test at every radius by the accurate solver; `others`:
/// predict_for_radius().
RadiusStudy study_radius(const ValidationData& data, const std::vector<Prediction>& at_tests,
                         const std::vector<Prediction>& others);

}  // namespace dashpad::report1986
