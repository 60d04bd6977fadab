// Figures 3-8 and 3-9: forces over energies, and what follows for the plate.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_figure_list.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double least_energy = 5, greatest_energy = 1000;    // in.lb
constexpr double least_force = 100, greatest_force = 10'000;  // lb

/// Energy over force, with the energy on the horizontal axis.
output::Series energy_line(const std::string& label, std::size_t turn, output::SeriesStyle style, double low,
                           double high, const std::function<double(double)>& energy_of_force) {
  output::Series line = function_line(
      label, turn, std::log(low), std::log(high), [](double log_force) { return std::exp(log_force); },
      style);
  for (std::size_t i = 0; i < line.y.size(); ++i) line.x[i] = energy_of_force(line.y[i]);
  return line;
}

output::Series energy_points(const Study& study, Projectile projectile, const char* label, std::size_t turn) {
  output::Series points{.label = label, .style = output::SeriesStyle::points, .turn = turn};
  for (const MeasuredTest& test : study.data.measured.tests) {
    if (test.projectile != projectile || !test.peak_force_lb) continue;
    points.x.push_back(test.energy_in_lb);
    points.y.push_back(*test.peak_force_lb);
  }
  return points;
}

/// A force over speed: solid for energies at which the trend was fitted, dashed below.
std::vector<output::Series> curve(const Study& study, const std::string& label, std::size_t turn,
                                  Projectile projectile,
                                  const std::function<double(double)>& force_of_speed) {
  const double fitted_from = study.data.constant("energy_trend_from_in_lb");
  const double unit_energy = impact_energy_in_lb(weight_of(study.data, projectile), 1);
  const double middle = std::clamp(std::sqrt(fitted_from / unit_energy), least_speed, greatest_speed);
  return {function_line(label, turn, middle, greatest_speed, force_of_speed, output::SeriesStyle::solid_line),
          function_line("", turn, least_speed, middle, force_of_speed, output::SeriesStyle::dashed_line)};
}

}  // namespace

std::vector<output::Series> curve_a(const Study& study, Projectile projectile, std::size_t turn) {
  return curve(study, "curve A: the report's trend, Eq. 36", turn, projectile,
               [&](double speed) { return curve_a_force_lb(study.data, projectile, speed); });
}

std::vector<output::Series> curve_b(const Study& study, Projectile projectile, std::size_t turn) {
  return curve(study, "curve B: the report's estimate for the plate, Eq. 37", turn, projectile,
               [&](double speed) { return curve_b_force_lb(study.data, projectile, speed); });
}

ValidationFigure force_over_energy(const Study& study) {
  const ValidationData& data = study.data;
  const double factor = data.constant("energy_trend_factor");
  const double exponent = data.constant("energy_trend_exponent");
  const double begin = data.constant("energy_trend_from_in_lb");
  output::Panel panel{
      .x = {.label = "Energy (in·lb)", .logarithmic = true, .low = least_energy, .high = greatest_energy},
      .y = {.label = axis_label(Quantity::peak_force),
            .logarithmic = true,
            .low = least_force,
            .high = greatest_force},
      .series = {}};
  panel.series.push_back(
      energy_line("stored in the load cell", turn::report, output::SeriesStyle::line, least_force,
                  greatest_force, [&](double force) { return support_energy_in_lb(data.load_cell, force); }));
  panel.series.push_back(
      energy_line("stored in the plate", turn::second, output::SeriesStyle::line, least_force, greatest_force,
                  [&](double force) { return force * force / (2 * data.plate_stiffness_lb_per_in); }));
  panel.series.push_back(
      energy_line(fmt::format("report, Eq. 36: U = ({} F)^{}", brief(factor), brief(exponent)),
                  turn::accurate, output::SeriesStyle::solid_line, trend_force_lb(begin, factor, exponent),
                  greatest_force, [&](double force) { return trend_energy_in_lb(force, factor, exponent); }));
  const FittedConstant* new_factor = fitted(study, "energy_trend_factor");
  const FittedConstant* new_exponent = fitted(study, "energy_trend_exponent");
  if (new_factor != nullptr && new_exponent != nullptr) {
    const double f = new_factor->value, e = new_exponent->value;
    panel.series.push_back(energy_line(fmt::format("fitted again: U = ({:.4g} F)^{:.3f}", f, e),
                                       turn::printed_1984, output::SeriesStyle::dashed_line,
                                       trend_force_lb(begin, f, e), greatest_force,
                                       [&](double force) { return trend_energy_in_lb(force, f, e); }));
  }
  panel.series.push_back(energy_points(study, Projectile::aluminium, "aluminium, measured", turn::measured));
  panel.series.push_back(energy_points(study, Projectile::steel, "steel, measured", turn::mended_1984));
  return {.name = "Figure 3-8",
          .slug = "figure-3-8",
          .plot = {.title = "Peak force over energy",
                   .panels = {panel},
                   .source = source_line("Table 3-1 and Eqs. 35 and 36")},
          .note = lost_readings(study, {"peak_force_lb"}, "peak force") +
                  "The trends are drawn for energies above 300 in·lb, for which the report fitted them. What "
                  "the load cell stores rests on its reconstructed curve."};
}

ValidationFigure curves_a_and_b(const Study& study) {
  output::Panel panel{.x = {.label = "Initial speed (mph)", .low = least_speed, .high = greatest_speed},
                      .y = {.label = axis_label(Quantity::peak_force), .low = 0, .high = 6000},
                      .series = curve_a(study, Projectile::aluminium, turn::accurate)};
  for (output::Series& series : curve_b(study, Projectile::aluminium, turn::printed_1984))
    panel.series.push_back(std::move(series));
  panel.series.push_back(measured_points(study, test_group::aluminium, Quantity::peak_force,
                                         "measured on the load cell", turn::measured));
  return {.name = "Figure 3-9",
          .slug = "figure-3-9",
          .plot = {.title = "Peak force over initial speed, aluminium projectile",
                   .panels = {panel},
                   .source = source_line("Table 3-1 and Eqs. 36 and 37")},
          .note = lost_readings(study, {"peak_force_lb"}, "peak force") + curve_note +
                  "No force was measured on the plate."};
}

}  // namespace dashpad::report1986
