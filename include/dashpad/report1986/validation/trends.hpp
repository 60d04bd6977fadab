#pragma once
/// The report's trend lines (section 3.3), fitted again to the readings of Table 3-1.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "dashpad/model/pad/material.hpp"
#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

/// A 95 % interval (Student's t) or a span.
struct Interval {
  double low = 0;
  double high = 0;
  [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
  /// Widens it to hold a value.
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};
/// What holds nothing yet.
inline constexpr Interval nowhere{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};

/// A constant fitted to the certain rows.
struct FittedConstant {
  std::string name = {};   ///< of the printed constant
  std::string title = {};  ///< "V T, load cell", for people
  std::string unit = {};
  double printed = 0;
  double value = 0;             ///< least squares over the certain rows
  Interval confidence = {};     ///< 95 %, of `value`, by the scatter of the rows
  std::vector<int> tests = {};  ///< the certain rows used
  double scatter = 0;           ///< standard deviation of the residuals, in the unit of the fitted quantity
  std::string residual_unit = {};
  /// Least and greatest value over all placings of the unplaced readings in their order; equal to `value`
  /// where there are none.
  Interval over_placings = {};
  /// From the lowest to the highest end of the 95 % intervals of all placings. The certain rows are no random
  /// sample of all, so this says more than `confidence` where many readings are lost.
  Interval confidence_over_placings = {};
  long placings = 0;
  bool printed_in_confidence = false;
  bool printed_in_placings = false;
  std::string method = {};  ///< in one line: what is minimised over which rows
};

/// All of them: travel VT with T = c/V (load cell); V_R/V of the load cell, of the plate, and of the plate
/// without its fastest test, as the report lays that line; exponent and factor of U = (factor F)^exponent for
/// energies above 300 in.lb, with the regression of ln U on ln F, and with that of ln F on ln U, since the
/// report does not say which it used.
std::vector<FittedConstant> fit_trends(const ValidationData& data);

/// Nominal stress (report, Eq. 33): e^m / (1 - e)^n (E_inf + E_r (V/L)^r), psi, with V/L in 1/s. Strain in
/// [0, 1). Throws std::invalid_argument where the material's law is not the 9-parameter law.
double nominal_stress_psi(const Material& ensolite, double peak_strain, double speed_mph,
                          double thickness_in);

/// Nominal stress against peak force: the line of unit slope, F = area * stress (report, Figure 3-5).
struct NominalStressPoint {
  int test = 0;  ///< 0 where the strain or the force is not certainly that test's
  double stress_psi = 0;
  double force_lb = 0;
};

/// Nearly all strains have lost their tests, so there is no one fit: what is found over all placings of
/// strains and forces in their order. The bounds are those of all placings, not of an error.
struct NominalStressFit {
  std::vector<NominalStressPoint> points;  ///< in the placing of least scatter about a line of unit slope
  double area_in2 = 0;                     ///< of that placing
  Interval area_over_placings;
  double scatter = 0;  ///< standard deviation of ln(F / stress) in that placing
  /// From `scatter` to a bound that no placing exceeds.
  Interval scatter_over_placings;
  double slope = 0;           ///< of ln F over ln stress in that placing, fitted freely
  Interval slope_confidence;  ///< 95 %, as if that placing were the true one
  std::string remark;         ///< which readings, how many placings, what cannot be told
};
NominalStressFit fit_nominal_stress(const ValidationData& data, const Material& ensolite);

}  // namespace dashpad::report1986
