// Figures 3-3 to 3-7: what was measured.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_figure_list.hpp"

namespace dashpad::report1986 {

namespace {

const output::Axis speed_axis{.label = "Initial speed (mph)", .low = least_speed, .high = greatest_speed};

/// T = travel / V, in ms for in and mph.
double time_of_travel(const Study& study, double travel_in, double speed_mph) {
  return 1e3 * travel_in / (study.data.constant("inch_per_s_of_mph") * speed_mph);
}

/// A fitted constant as a band over speed: its 95 % interval.
output::Series interval_band(const FittedConstant& constant, const std::string& label, std::size_t turn,
                             const std::function<double(double, double)>& value) {
  output::Series band = function_line(
      label, turn, least_speed, greatest_speed,
      [&](double speed) { return value(constant.confidence.low, speed); }, output::SeriesStyle::band);
  for (const double speed : band.x) band.y2.push_back(value(constant.confidence.high, speed));
  return band;
}

output::Panel measured_time_panel(const Study& study, const char* title, TestGroup group) {
  output::Panel panel{.title = title,
                      .x = speed_axis,
                      .y = {.label = axis_label(Quantity::time_to_peak), .low = 0},
                      .series = predicted_lines(study, {Program::accurate, Program::printed_1984}, group,
                                                Quantity::time_to_peak)};
  const auto travel_time = [&](double travel, double speed) { return time_of_travel(study, travel, speed); };
  if (const FittedConstant* refit = fitted(study, "travel_in")) {
    panel.series.push_back(
        interval_band(*refit, "fitted again: 95 % interval", turn::mended_1984, travel_time));
    panel.series.push_back(function_line(
        fmt::format("fitted again: VT = {:.2f} in", refit->value), turn::mended_1984, least_speed,
        greatest_speed, [&](double speed) { return travel_time(refit->value, speed); },
        output::SeriesStyle::solid_line));
  }
  for (const auto& [name, words, turn] :
       {std::tuple{"travel_in", "report's fit", turn::report},
        std::tuple{"expected_travel_in", "report's expectation", turn::second}}) {
    const double travel = study.data.constant(name);
    panel.series.push_back(function_line(fmt::format("{}: VT = {} in", words, brief(travel)), turn,
                                         least_speed, greatest_speed,
                                         [&](double speed) { return travel_time(travel, speed); }));
  }
  panel.series.push_back(measured_points(study, group, Quantity::time_to_peak, "measured", turn::measured));
  return panel;
}

}  // namespace

ValidationFigure support_curves(const Study& study) {
  output::Series load_cell{.label = "load cell with bearing plate and floor: RECONSTRUCTED",
                           .style = output::SeriesStyle::solid_line,
                           .x = {0},
                           .y = {0},
                           .turn = turn::accurate};
  for (const StaticPoint& point : study.data.load_cell) {
    load_cell.x.push_back(point.deflection_in);
    load_cell.y.push_back(point.force_lb);
  }
  constexpr double farthest = 0.6;
  const double stiffness = study.data.plate_stiffness_lb_per_in;
  output::Panel panel{
      .x = {.label = "Deflection (in)", .low = 0, .high = farthest},
      .y = {.label = "Force (lb)", .low = 0, .high = 6000},
      .series = {load_cell,
                 function_line(fmt::format("flexible plate: {} lb/in (calculated)", brief(stiffness)),
                               turn::printed_1984, 0, farthest, [&](double x) { return stiffness * x; })}};
  return {.name = "Figure 3-3",
          .slug = "figure-3-3",
          .plot = {.title = "Static curves of the supports",
                   .panels = {panel},
                   .source = source_line("section 3.3, Table 3-2")},
          .note =
              "The report's figure is lost. The load cell's curve is reconstructed from the slopes and the "
              "stored energies that the report prints; every prediction on the load cell rests on it."};
}

ValidationFigure time_to_peak(const Study& study) {
  return {
      .name = "Figure 3-4",
      .slug = "figure-3-4",
      .plot = {.title = "Time to peak force over initial speed, load cell",
               .panels = {measured_time_panel(study, "Aluminium projectile, 4.13 lb", test_group::aluminium),
                          measured_time_panel(study, "Steel projectile, 7.7 lb", test_group::steel)},
               .source = source_line("Table 3-1 and section 3.3")},
      .note = lost_readings(study, {"time_to_peak_ms"}, "time to peak") + radius_note(study)};
}

ValidationFigure nominal_stress(const Study& study) {
  const NominalStressFit& fit = study.nominal_stress;
  output::Series certain{
      .label = "strain of the same test", .style = output::SeriesStyle::points, .turn = turn::measured};
  output::Series placed{.label = "strain whose test is lost, in the placing of least scatter",
                        .style = output::SeriesStyle::points,
                        .turn = turn::mended_1984};
  Interval forces{.low = HUGE_VAL, .high = 0};
  for (const NominalStressPoint& point : fit.points) {
    output::Series& series = point.test == 0 ? placed : certain;
    series.x.push_back(point.force_lb);
    series.y.push_back(point.stress_psi);
    forces = {.low = std::min(forces.low, point.force_lb), .high = std::max(forces.high, point.force_lb)};
  }
  output::Panel panel{.x = {.label = "Peak force (lb)", .logarithmic = true},
                      .y = {.label = "Nominal stress (psi)", .logarithmic = true},
                      .series = {}};
  if (!fit.points.empty()) {
    const double low = 0.8 * forces.low, high = 1.25 * forces.high;
    panel.series = {{.label = "over all placings",
                     .style = output::SeriesStyle::band,
                     .x = {low, high},
                     .y = {low / fit.area_over_placings.high, high / fit.area_over_placings.high},
                     .y2 = {low / fit.area_over_placings.low, high / fit.area_over_placings.low},
                     .turn = turn::accurate},
                    {.label = fmt::format("unit slope: force = {:.3g} in² x stress", fit.area_in2),
                     .style = output::SeriesStyle::solid_line,
                     .x = {low, high},
                     .y = {low / fit.area_in2, high / fit.area_in2},
                     .turn = turn::accurate},
                    certain,
                    placed};
  }
  return {.name = "Figure 3-5",
          .slug = "figure-3-5",
          .plot = {.title = "Nominal stress (Eq. 33) over peak force, load cell",
                   .panels = {panel},
                   .source = source_line("Table 3-1 and Eq. 33")},
          .note = fit.remark};
}

ValidationFigure force_over_speed(const Study& study) {
  output::Panel panel{
      .x = speed_axis, .y = {.label = axis_label(Quantity::peak_force), .low = 0}, .series = {}};
  const auto add = [&](TestGroup group, const char* name, std::size_t turn) {
    for (output::Series series : predicted_lines(study, Program::accurate, group, Quantity::peak_force)) {
      series.label += std::string{", "} + name;
      series.turn = turn;
      panel.series.push_back(series);
    }
    panel.series.push_back(
        measured_points(study, group, Quantity::peak_force, std::string{"measured, "} + name, turn));
  };
  add(test_group::aluminium, "aluminium", turn::accurate);
  add(test_group::steel, "steel", turn::printed_1984);
  return {.name = "Figure 3-6",
          .slug = "figure-3-6",
          .plot = {.title = "Peak force over initial speed, load cell",
                   .panels = {panel},
                   .source = source_line("Table 3-1")},
          .note = lost_readings(study, {"peak_force_lb"}, "peak force") + radius_note(study) +
                  "The other programs: Figure 4-2."};
}

ValidationFigure rebound_over_speed(const Study& study) {
  output::Panel panel{
      .x = speed_axis, .y = {.label = axis_label(Quantity::rebound_speed), .low = 0}, .series = {}};
  for (const auto& [name, support, turn] :
       {std::tuple{"rebound_ratio_load_cell", "load cell", turn::accurate},
        std::tuple{"rebound_ratio_plate", "plate", turn::printed_1984}}) {
    const auto times_speed = [](double ratio, double speed) { return ratio * speed; };
    if (const FittedConstant* refit = fitted(study, name))
      panel.series.push_back(interval_band(
          *refit, fmt::format("fitted again: {:.3f} V, {}", refit->value, support), turn, times_speed));
    const double ratio = study.data.constant(name);
    panel.series.push_back(function_line(fmt::format("report: {} V, {}", brief(ratio), support), turn,
                                         least_speed, greatest_speed,
                                         [&](double speed) { return ratio * speed; }));
  }
  const auto add = [&](TestGroup group, const char* label, std::size_t turn) {
    panel.series.push_back(measured_points(study, group, Quantity::rebound_speed, label, turn));
  };
  add(test_group::aluminium, "aluminium on load cell", turn::accurate);
  add(test_group::steel, "steel on load cell", turn::second);
  add(test_group::on_plate, "aluminium on plate", turn::printed_1984);
  return {
      .name = "Figure 3-7",
      .slug = "figure-3-7",
      .plot = {.title = "Rebound speed over initial speed",
               .panels = {panel},
               .source = source_line("Table 3-1 and section 3.3")},
      .note = lost_readings(study, {"rebound_mph"}, "rebound speed") +
              "Bands: 95 % intervals of the ratios, fitted again to the certain rows. The predictions are "
              "in Figures 4-4 and 4-5."};
}

}  // namespace dashpad::report1986
