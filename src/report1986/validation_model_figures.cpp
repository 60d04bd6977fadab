// Figures 4-1 to 4-5: predictions of the programs beside the measurements.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_figures.hpp"

namespace dashpad::report1986 {

namespace {

/// The plate is linear, so the support defect and the first slope change nothing.
const std::vector<Program> programs_on_plate{Program::accurate, Program::printed_1984};

Panel predicted_time_panel(const Study& study, const char* title, TestGroup group) {
  Panel panel = speed_panel(title, Quantity::time_to_peak);
  panel.add(predicted_lines(study, programs, group, Quantity::time_to_peak));
  for (const auto& [name, palette_index] : {std::pair{"travel_in", palette_index::report},
                                            std::pair{"expected_travel_in", palette_index::second}}) {
    const double travel = study.data.constant(name);
    const double travel_ms = 1e3 * travel / study.data.constant("inch_per_s_of_mph");
    panel.add(speed_line(fmt::format("report: VT = {} in", brief(travel)), palette_index,
                         [&](double speed) { return travel_ms / speed; }));
  }
  return panel;
}

Panel force_panel(const Study& study, const char* title, TestGroup group) {
  Panel panel = speed_panel(title, Quantity::peak_force);
  panel.y.high = 10'000;
  panel.add(predicted_lines(study, programs, group, Quantity::peak_force));
  panel.add(curve_a(study, group.projectile, palette_index::report));
  panel.add(measured_points(study, group, Quantity::peak_force, "measured", palette_index::measured));
  return panel;
}

/// The upper bound of the rebound as in Table 3-2, with the peak force of the trend.
Series expected_on_load_cell(const Study& study, Projectile projectile) {
  const ValidationData& data = study.data;
  const double ratio = data.constant("rebound_ratio_load_cell");
  const double from = data.constant("energy_trend_from_in_lb");
  const double greatest =
      projectile == Projectile::steel ? 16 : greatest_speed;  // Eq. 36 does not hold beyond
  return function_line("upper bound (Table 3-2)", palette_index::second, min_speed, greatest,
                       [&](double speed) {
                         const double energy = impact_energy_in_lb(weight_of(data, projectile), speed);
                         if (energy < from) return std::nan("");
                         const double force = trend_force_lb(energy, data.constant("energy_trend_factor"),
                                                             data.constant("energy_trend_exponent"));
                         return expectation(data, projectile, speed, force, ratio).rebound_mph;
                       });
}

/// The same bound for the plate, with the peak force of curve B, and at most the initial speed.
Series expected_on_plate(const Study& study) {
  const ValidationData& data = study.data;
  const double ratio = data.constant("rebound_ratio_plate");
  Series line = curve_b(study, Projectile::aluminium, palette_index::second).front();
  line.label = "upper bound (Table 3-2)";
  line.style = SeriesStyle::line;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const double energy = impact_energy_in_lb(weight_of(data, Projectile::aluminium), line.x[i]);
    const double stored = line.y[i] * line.y[i] / (2 * data.plate_stiffness_lb_per_in);
    line.y[i] = line.x[i] * std::min(1.0, std::sqrt(ratio * ratio + stored / energy));
  }
  return line;
}

Series printed_expectation(const Study& study, Projectile projectile) {
  Series points{.label = "example from Table 3-2",
                .style = SeriesStyle::points,
                .palette_index = palette_index::second};
  for (const ExpectationExample& example : study.data.table_3_2) {
    if (example.projectile != projectile) continue;
    points.add(example.speed_mph, example.rebound_mph);
  }
  return points;
}

Panel rebound_panel(const Study& study, const char* title, TestGroup group) {
  Panel panel = speed_panel(title, Quantity::rebound_speed);
  const bool plate = group.support == TestSupport::plate;
  panel.add(predicted_lines(study, plate ? programs_on_plate : programs, group, Quantity::rebound_speed));
  const double ratio = study.data.constant(plate ? "rebound_ratio_plate" : "rebound_ratio_load_cell");
  panel.add(speed_line(fmt::format("report: {} V", brief(ratio)), palette_index::report,
                       [&](double speed) { return ratio * speed; }));
  panel.add(plate ? expected_on_plate(study) : expected_on_load_cell(study, group.projectile));
  if (!plate) panel.add(printed_expectation(study, group.projectile));
  panel.add(measured_points(study, group, Quantity::rebound_speed, "measured", palette_index::measured));
  return panel;
}

}  // namespace

Drawing predicted_time(const Study& study) {
  return {both_projectiles(study, predicted_time_panel),
          radius_note(study) + "Figure 3-4 shows the measured times."};
}

Drawing predicted_force_on_load_cell(const Study& study) {
  return {both_projectiles(study, force_panel),
          lost_readings(study, "peak_force_lb", "peak force") + radius_note(study) + curve_note};
}

Drawing predicted_force_on_plate(const Study& study) {
  Panel panel = speed_panel("", Quantity::peak_force);
  panel.add(predicted_lines(study, programs_on_plate, test_group::on_plate, Quantity::peak_force));
  panel.add(curve_b(study, Projectile::aluminium, palette_index::report));
  return {{panel},
          radius_note(study) + curve_note +
              "No force was measured on the plate: curve B is the report's estimate."};
}

Drawing predicted_rebound_on_load_cell(const Study& study) {
  return {both_projectiles(study, rebound_panel),
          lost_readings(study, "rebound_mph", "rebound speed") + radius_note(study) +
              "The upper bound, above 300 in·lb, assumes that all energy stored in the support is lost."};
}

Drawing predicted_rebound_on_plate(const Study& study) {
  return {{rebound_panel(study, "", test_group::on_plate)},
          radius_note(study) +
              "The upper bound follows Table 3-2 with the force from curve B, but never exceeds the initial "
              "speed; the plate stores so much energy that this bound means little."};
}

}  // namespace dashpad::report1986
