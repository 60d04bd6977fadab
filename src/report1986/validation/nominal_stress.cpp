#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "dashpad/report1986/validation/trends.hpp"
#include "report1986/validation/nominal_stress_placings.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation/trends_least_squares.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double pound_per_square_inch = 4.4482216152605 / (0.0254 * 0.0254);  // Pa
constexpr std::size_t fewest_points = 3;                                       // for a slope with an interval

/// Lines of unit slope that are tried between the extreme ones. The least scatter is found to within half a
/// step, a thousandth of the range.
constexpr int lines = 500;

std::vector<Point> logarithms(const std::vector<NominalStressPoint>& points) {
  std::vector<Point> logs;
  for (const NominalStressPoint& point : points)
    logs.push_back({std::log(point.stress_psi), std::log(point.force_lb)});
  return logs;
}

double mean_log_ratio(const std::vector<NominalStressPoint>& points) {
  double sum = 0;
  for (const Point& point : logarithms(points)) sum += point.y - point.x;
  return sum / static_cast<double>(points.size());
}

double deviation(double squares, std::size_t points) {
  return std::sqrt(squares / static_cast<double>(points - 1));
}

double scatter_of(const std::vector<NominalStressPoint>& points) {
  const double mean = mean_log_ratio(points);
  double squares = 0;
  for (const Point& point : logarithms(points)) squares += std::pow(point.y - point.x - mean, 2);
  return deviation(squares, points.size());
}

/// Least and greatest mean of ln(F / stress), over all placings with points.
Interval means_over(const NominalStressPlacings& placings) {
  Interval means{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto& [points, least] : placings.least([](double ratio) { return ratio; }))
    if (points > 0) means.low = std::min(means.low, least.sum / static_cast<double>(points));
  for (const auto& [points, least] : placings.least([](double ratio) { return -ratio; }))
    if (points > 0) means.high = std::max(means.high, -least.sum / static_cast<double>(points));
  return means;
}

/// Sets the placing of least scatter, and the span of the scatter. A placing scatters least about its own
/// mean; so the least about any line is the least of all, and the greatest about one line exceeds all.
void scan_lines(const NominalStressPlacings& placings, const Interval& means, NominalStressFit& fit) {
  fit.scatter = std::numeric_limits<double>::infinity();
  std::map<std::size_t, double> bounds;
  for (int i = 0; i <= lines; ++i) {
    const double line = means.low + (means.high - means.low) * i / lines;
    const auto square = [line](double ratio) { return (ratio - line) * (ratio - line); };
    for (const auto& [count, least] : placings.least(square)) {
      if (count < fewest_points) continue;
      const double scatter = scatter_of(least.points);
      if (scatter >= fit.scatter) continue;
      fit.scatter = scatter;
      fit.points = least.points;
    }
    for (const auto& [count, least] : placings.least([&](double ratio) { return -square(ratio); })) {
      if (count < fewest_points) continue;
      const double bound = deviation(-least.sum, count);
      const auto known = bounds.emplace(count, bound).first;
      known->second = std::min(known->second, bound);
    }
  }
  if (fit.points.empty()) fit.scatter = 0;
  fit.scatter_over_placings = {fit.scatter, fit.scatter};
  for (const auto& [count, bound] : bounds)
    fit.scatter_over_placings.high = std::max(fit.scatter_over_placings.high, bound);
}

std::string remark_on(const ValidationData& data, const NominalStressFit& fit) {
  double ways = 1;
  for (const char* column : {"plug_strain", "diameter_strain", "peak_force_lb"})
    ways *= placings(data.measured, column);
  return fmt::format(
      "The placing of least scatter, {} points of {:.2g} placings: nearly all strains have lost their tests, "
      "and "
      "some forces. It is the most favourable choice, not the report's Figure 3-5, which has {:g} tests, and "
      "{:g} "
      "of them in its fit; that cannot be rebuilt.",
      fit.points.size(), ways, data.constant("nominal_stress_tests"),
      data.constant("nominal_stress_clustered_tests"));
}

}  // namespace

double nominal_stress_psi(const Material& ensolite, double peak_strain, double speed_mph,
                          double thickness_in) {
  const auto* law = std::get_if<NineParameter>(&ensolite.law);
  if (!law) throw std::invalid_argument("the nominal stress needs the 9-parameter law");
  const double rate = inch_per_s_of_mph * speed_mph / thickness_in;
  const double shape =
      std::pow(peak_strain, law->contact_exponent) / std::pow(1 - peak_strain, law->compaction_exponent);
  const double modulus = law->asymptotic_modulus + law->rate_modulus * std::pow(rate, law->rate_exponent);
  return shape * modulus / pound_per_square_inch;
}

NominalStressFit fit_nominal_stress(const ValidationData& data, const Material& ensolite) {
  const NominalStressPlacings placings(data.measured, [&](const MeasuredTest& test) {
    return nominal_stress_psi(ensolite, *peak_strain(test), test.speed_mph, data.pad_thickness_in);
  });
  const Interval means = means_over(placings);
  NominalStressFit fit;
  if (!(means.low <= means.high)) {
    fit.remark = "No test has both a strain and a force.";
    return fit;
  }
  scan_lines(placings, means, fit);
  if (fit.points.empty()) {
    fit.remark = "Too few tests have both a strain and a force.";
    return fit;
  }
  fit.area_in2 = std::exp(mean_log_ratio(fit.points));
  fit.area_over_placings = {std::exp(means.low), std::exp(means.high)};
  const LineFit line = fit_line(logarithms(fit.points));
  fit.slope = line.slope.value;
  fit.slope_confidence = line.slope.confidence;
  fit.remark = remark_on(data, fit);
  return fit;
}

}  // namespace dashpad::report1986
