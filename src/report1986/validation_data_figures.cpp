// Figures 3-3 to 3-9: measurements, forces over energies, and the conclusions for the plate.

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_figures.hpp"

namespace dashpad::report1986 {

namespace {

/// The first fitted constant of that name; null if there is none.
const FittedConstant* fitted(const Study& study, const std::string& name) {
  const auto found = std::ranges::find(study.constants, name, &FittedConstant::name);
  return found == study.constants.end() ? nullptr : &*found;
}

/// The 95 % interval of a fitted constant as a band over speed.
Series interval_band(const FittedConstant& constant, const std::string& label, std::size_t palette_index,
                     const std::function<double(double, double)>& value) {
  Series band = speed_line(
      label, palette_index, [&](double speed) { return value(constant.confidence.low, speed); },
      SeriesStyle::band);
  for (const double speed : band.x) band.y2.push_back(value(constant.confidence.high, speed));
  return band;
}

Panel measured_time_panel(const Study& study, const char* title, TestGroup group) {
  Panel panel = speed_panel(title, Quantity::time_to_peak);
  panel.add(
      predicted_lines(study, {Program::accurate, Program::printed_1984}, group, Quantity::time_to_peak));
  // T = travel / V, in ms for in and mph.
  const double inch_per_s = study.data.constant("inch_per_s_of_mph");
  const auto travel_time = [&](double travel, double speed) { return 1e3 * travel / (inch_per_s * speed); };
  const auto line_of = [&](const std::string& label, std::size_t palette_index, double travel,
                           SeriesStyle style = SeriesStyle::line) {
    panel.add(speed_line(
        label, palette_index, [&](double speed) { return travel_time(travel, speed); }, style));
  };
  if (const FittedConstant* refit = fitted(study, "travel_in")) {
    panel.add(interval_band(*refit, "refitted: 95 % interval", palette_index::mended_1984, travel_time));
    line_of(fmt::format("refitted: VT = {:.2f} in", refit->value), palette_index::mended_1984, refit->value,
            SeriesStyle::solid_line);
  }
  for (const auto& [name, words, palette_index] :
       {std::tuple{"travel_in", "report's fit", palette_index::report},
        std::tuple{"expected_travel_in", "report's expectation", palette_index::second}}) {
    const double travel = study.data.constant(name);
    line_of(fmt::format("{}: VT = {} in", words, brief(travel)), palette_index, travel);
  }
  panel.add(measured_points(study, group, Quantity::time_to_peak, "measured", palette_index::measured));
  return panel;
}

constexpr double min_force = 100, greatest_force = 10'000;  // lb

/// Energy over force, with the energy on the horizontal axis.
Series energy_line(const std::string& label, std::size_t palette_index, SeriesStyle style, double low,
                   const std::function<double(double)>& energy_of_force) {
  Series line = function_line(
      label, palette_index, std::log(low), std::log(greatest_force),
      [](double log_force) { return std::exp(log_force); }, style);
  for (std::size_t i = 0; i < line.y.size(); ++i) line.x[i] = energy_of_force(line.y[i]);
  return line;
}

Series energy_points(const Study& study, Projectile projectile, const char* label,
                     std::size_t palette_index) {
  Series points{.label = label, .style = SeriesStyle::points, .palette_index = palette_index};
  for (const MeasuredTest& test : study.data.measured.tests) {
    if (test.projectile != projectile || !test.peak_force_lb) continue;
    points.add(test.energy_in_lb, *test.peak_force_lb);
  }
  return points;
}

}  // namespace

Drawing support_curves(const Study& study) {
  Series load_cell{.label = "load cell with bearing plate and floor: RECONSTRUCTED",
                   .style = SeriesStyle::solid_line,
                   .x = {0},
                   .y = {0},
                   .palette_index = palette_index::accurate};
  for (const StaticPoint& point : study.data.load_cell) load_cell.add(point.deflection_in, point.force_lb);
  constexpr double farthest = 0.6;
  const double stiffness = study.data.plate_stiffness_lb_per_in;
  Panel panel{.x = {.label = "Deflection (in)", .low = 0, .high = farthest},
              .y = {.label = "Force (lb)", .low = 0, .high = 6000},
              .series = {load_cell,
                         function_line(fmt::format("flexible plate: {} lb/in (calculated)", brief(stiffness)),
                                       palette_index::printed_1984, 0, farthest,
                                       [&](double x) { return stiffness * x; })}};
  return {{panel},
          "The report's figure is lost. The curve of the load cell is reconstructed from slopes and stored "
          "energies in the report; every prediction for the load cell depends on it."};
}

Drawing time_to_peak(const Study& study) {
  return {both_projectiles(study, measured_time_panel),
          lost_readings(study, "time_to_peak_ms", "time to peak") + radius_note(study)};
}

Drawing nominal_stress(const Study& study) {
  const NominalStressFit& fit = study.nominal_stress;
  Series certain{.label = "strain from the same test",
                 .style = SeriesStyle::points,
                 .palette_index = palette_index::measured};
  Series placed{.label = "strain whose test is unknown, in the assignment with the least scatter",
                .style = SeriesStyle::points,
                .palette_index = palette_index::mended_1984};
  Interval forces = nowhere;
  for (const NominalStressPoint& point : fit.points) {
    Series& series = point.test == 0 ? placed : certain;
    series.add(point.force_lb, point.stress_psi);
    forces.include(point.force_lb);
  }
  Panel panel{.x = {.label = "Peak force (lb)", .logarithmic = true},
              .y = {.label = "Nominal stress (psi)", .logarithmic = true}};
  if (!fit.points.empty()) {
    const double low = 0.8 * forces.low, high = 1.25 * forces.high;
    panel.series = {{.label = "range over all assignments",
                     .style = SeriesStyle::band,
                     .x = {low, high},
                     .y = {low / fit.area_over_placings.high, high / fit.area_over_placings.high},
                     .y2 = {low / fit.area_over_placings.low, high / fit.area_over_placings.low},
                     .palette_index = palette_index::accurate},
                    {.label = fmt::format("unit slope: force = {:.3g} in² x stress", fit.area_in2),
                     .style = SeriesStyle::solid_line,
                     .x = {low, high},
                     .y = {low / fit.area_in2, high / fit.area_in2},
                     .palette_index = palette_index::accurate},
                    certain,
                    placed};
  }
  return {{panel}, fit.remark};
}

Drawing force_over_speed(const Study& study) {
  Panel panel = speed_panel("", Quantity::peak_force);
  for (const auto& [group, name, palette_index] :
       {std::tuple{test_group::aluminium, "aluminium", palette_index::accurate},
        std::tuple{test_group::steel, "steel", palette_index::printed_1984}}) {
    for (Series& series : predicted_lines(study, {Program::accurate}, group, Quantity::peak_force)) {
      series.label += std::string{", "} + name;
      series.palette_index = palette_index;
      panel.add(std::move(series));
    }
    panel.add(
        measured_points(study, group, Quantity::peak_force, std::string{"measured, "} + name, palette_index));
  }
  return {{panel},
          lost_readings(study, "peak_force_lb", "peak force") + radius_note(study) +
              "Figure 4-2 shows the other programs."};
}

Drawing rebound_over_speed(const Study& study) {
  Panel panel = speed_panel("", Quantity::rebound_speed);
  for (const auto& [name, support, palette_index] :
       {std::tuple{"rebound_ratio_load_cell", "load cell", palette_index::accurate},
        std::tuple{"rebound_ratio_plate", "plate", palette_index::printed_1984}}) {
    const auto times_speed = [](double ratio, double speed) { return ratio * speed; };
    if (const FittedConstant* refit = fitted(study, name))
      panel.add(interval_band(*refit, fmt::format("refitted: {:.3f} V, {}", refit->value, support),
                              palette_index, times_speed));
    const double ratio = study.data.constant(name);
    panel.add(speed_line(fmt::format("report: {} V, {}", brief(ratio), support), palette_index,
                         [&](double speed) { return ratio * speed; }));
  }
  for (const auto& [group, label, palette_index] :
       {std::tuple{test_group::aluminium, "aluminium on load cell", palette_index::accurate},
        std::tuple{test_group::steel, "steel on load cell", palette_index::second},
        std::tuple{test_group::on_plate, "aluminium on plate", palette_index::printed_1984}})
    panel.add(measured_points(study, group, Quantity::rebound_speed, label, palette_index));
  return {{panel},
          lost_readings(study, "rebound_mph", "rebound speed") +
              "The bands are 95 % intervals for the ratios, refitted to the readings whose test is known. "
              "The predictions are in Figures 4-4 and 4-5."};
}

Drawing force_over_energy(const Study& study) {
  const ValidationData& data = study.data;
  const double factor = data.constant("energy_trend_factor");
  const double exponent = data.constant("energy_trend_exponent");
  const double begin = data.constant("energy_trend_from_in_lb");
  Panel panel{.x = {.label = "Energy (in·lb)", .logarithmic = true, .low = 5, .high = 1000},
              .y = {.label = axis_label(Quantity::peak_force),
                    .logarithmic = true,
                    .low = min_force,
                    .high = greatest_force}};
  panel.series = {
      energy_line("stored in the load cell", palette_index::report, SeriesStyle::line, min_force,
                  [&](double force) { return support_energy_in_lb(data.load_cell, force); }),
      energy_line("stored in the plate", palette_index::second, SeriesStyle::line, min_force,
                  [&](double force) { return force * force / (2 * data.plate_stiffness_lb_per_in); }),
      energy_line(fmt::format("report, Eq. 36: U = ({} F)^{}", brief(factor), brief(exponent)),
                  palette_index::accurate, SeriesStyle::solid_line, trend_force_lb(begin, factor, exponent),
                  [&](double force) { return trend_energy_in_lb(force, factor, exponent); })};
  const FittedConstant* new_factor = fitted(study, "energy_trend_factor");
  const FittedConstant* new_exponent = fitted(study, "energy_trend_exponent");
  if (new_factor != nullptr && new_exponent != nullptr) {
    const double f = new_factor->value, e = new_exponent->value;
    panel.add(energy_line(fmt::format("refitted: U = ({:.4g} F)^{:.3f}", f, e), palette_index::printed_1984,
                          SeriesStyle::dashed_line, trend_force_lb(begin, f, e),
                          [&](double force) { return trend_energy_in_lb(force, f, e); }));
  }
  panel.add(energy_points(study, Projectile::aluminium, "aluminium, measured", palette_index::measured));
  panel.add(energy_points(study, Projectile::steel, "steel, measured", palette_index::mended_1984));
  return {{panel},
          lost_readings(study, "peak_force_lb", "peak force") +
              "The trends are drawn for energies above 300 in·lb, to which the report fitted them. The "
              "energy stored in the load cell is based on its reconstructed curve."};
}

Drawing curves_a_and_b(const Study& study) {
  Panel panel = speed_panel("", Quantity::peak_force);
  panel.y.high = 6000;
  panel.add(curve_a(study, Projectile::aluminium, palette_index::accurate));
  panel.add(curve_b(study, Projectile::aluminium, palette_index::printed_1984));
  panel.add(measured_points(study, test_group::aluminium, Quantity::peak_force, "measured on the load cell",
                            palette_index::measured));
  return {{panel},
          lost_readings(study, "peak_force_lb", "peak force") + curve_note +
              "No force was measured on the plate."};
}

}  // namespace dashpad::report1986
