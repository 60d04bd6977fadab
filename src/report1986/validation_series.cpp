#include "report1986/validation_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "quantities/text.hpp"

namespace dashpad::report1986 {

namespace {

struct Look {
  std::size_t palette_index;
  SeriesStyle style;
};
/// Indexed by Program. The program of 1984 has points because many of its runs end in an ABEND.
constexpr Look looks[] = {{palette_index::printed_1984, SeriesStyle::points},
                          {palette_index::mended_1984, SeriesStyle::points},
                          {palette_index::accurate, SeriesStyle::solid_line},
                          {palette_index::first_slope, SeriesStyle::line}};

std::vector<Series> lines_of(const Study& study, Program program, TestGroup group, Quantity quantity) {
  const double of_the_report = study.radius.of_the_report_in(), favoured = study.radius.favoured_in();
  const Look& look = looks[static_cast<std::size_t>(program)];
  std::map<double, double> at_the_reports_radius, at_the_favoured_radius;
  std::map<double, Interval> over_radii;
  for (const Prediction& prediction : study.on_curves) {
    const Setup& setup = prediction.setup;
    const std::optional<double> value = predicted(prediction, quantity);
    if (prediction.program != program || setup.projectile != group.projectile ||
        setup.support != group.support || !value)
      continue;
    if (setup.radius_in == favoured) at_the_favoured_radius[setup.speed_mph] = *value;
    if (setup.radius_in == of_the_report) at_the_reports_radius[setup.speed_mph] = *value;
    over_radii.emplace(setup.speed_mph, nowhere).first->second.include(*value);
  }
  const auto line_of = [&](const std::map<double, double>& values, double radius, SeriesStyle drawn) {
    Series line{.label = fmt::format("{}, {:.2f} in", to_string(program), radius),
                .style = drawn,
                .palette_index = look.palette_index};
    for (const auto& [speed, value] : values) line.add(speed, value);
    return line;
  };
  const Series line = line_of(at_the_reports_radius, of_the_report, look.style);
  if (program != Program::accurate) return {line};

  Series band{.label = std::string{to_string(program)} + ", range over nose radii",
              .style = SeriesStyle::band,
              .palette_index = look.palette_index};
  for (const auto& [speed, span] : over_radii) {
    band.add(speed, span.low);
    band.y2.push_back(span.high);
  }
  if (favoured == of_the_report) return {band, line};
  return {band, line, line_of(at_the_favoured_radius, favoured, SeriesStyle::dashed_line)};
}

/// A force over speed: solid at energies to which the trend was fitted, dashed below.
std::vector<Series> curve(const Study& study, const std::string& label, std::size_t palette_index,
                          Projectile projectile, const std::function<double(double)>& force_of_speed) {
  const double fitted_from = study.data.constant("energy_trend_from_in_lb");
  const double unit_energy = impact_energy_in_lb(weight_of(study.data, projectile), 1);
  const double middle = std::clamp(std::sqrt(fitted_from / unit_energy), min_speed, greatest_speed);
  return {
      function_line(label, palette_index, middle, greatest_speed, force_of_speed, SeriesStyle::solid_line),
      function_line("", palette_index, min_speed, middle, force_of_speed, SeriesStyle::dashed_line)};
}

}  // namespace

Panel speed_panel(const std::string& title, const std::string& label) {
  return {.title = title,
          .x = {.label = "Initial speed (mph)", .low = min_speed, .high = greatest_speed},
          .y = {.label = label, .low = 0}};
}

Panel speed_panel(const std::string& title, Quantity quantity) {
  return speed_panel(title, axis_label(quantity));
}

std::vector<Panel> both_projectiles(const Study& study,
                                    Panel (*panel_of)(const Study&, const char* title, TestGroup group)) {
  return {panel_of(study, "Aluminium projectile, 4.13 lb", test_group::aluminium),
          panel_of(study, "Steel projectile, 7.7 lb", test_group::steel)};
}

Series measured_points(const Study& study, TestGroup group, Quantity quantity, const std::string& label,
                       std::size_t palette_index) {
  Series points{.label = label, .style = SeriesStyle::points, .palette_index = palette_index};
  for (const MeasuredTest& test : study.data.measured.tests) {
    const std::optional<double> value = measured(test, quantity);
    if (!value || test.projectile != group.projectile || test.support != group.support) continue;
    points.add(test.speed_mph, *value);
  }
  return points;
}

std::vector<Series> predicted_lines(const Study& study, const std::vector<Program>& shown, TestGroup group,
                                    Quantity quantity) {
  std::vector<Series> all;
  for (const Program program : shown)
    for (Series& series : lines_of(study, program, group, quantity)) all.push_back(std::move(series));
  return all;
}

Series function_line(const std::string& label, std::size_t palette_index, double low, double high,
                     const std::function<double(double)>& value, SeriesStyle style) {
  constexpr int steps = 100;
  Series line{.label = label, .style = style, .palette_index = palette_index};
  for (int i = 0; i <= steps; ++i) {
    const double x = low + (high - low) * i / steps;
    line.add(x, value(x));
  }
  return line;
}

Series speed_line(const std::string& label, std::size_t palette_index,
                  const std::function<double(double)>& value, SeriesStyle style) {
  return function_line(label, palette_index, min_speed, greatest_speed, value, style);
}

std::vector<Series> curve_a(const Study& study, Projectile projectile, std::size_t palette_index) {
  return curve(study, "curve A: the report's trend, Eq. 36", palette_index, projectile,
               [&](double speed) { return curve_a_force_lb(study.data, projectile, speed); });
}

std::vector<Series> curve_b(const Study& study, Projectile projectile, std::size_t palette_index) {
  return curve(study, "curve B: the report's estimate for the plate, Eq. 37", palette_index, projectile,
               [&](double speed) { return curve_b_force_lb(study.data, projectile, speed); });
}

const MeasuredTest& test_of(const Study& study, int number) {
  const auto found = std::ranges::find(study.data.measured.tests, number, &MeasuredTest::number);
  if (found == study.data.measured.tests.end())
    throw std::out_of_range(fmt::format("there is no test {}", number));
  return *found;
}

std::string lost_readings(const Study& study, const std::string& column, const std::string& what) {
  std::size_t count = 0;
  for (const UnplacedReadings& group : study.data.measured.unplaced)
    if (group.column == column) count += group.readings.size();
  if (count == 0) return "";
  return fmt::format("{} of {} whose test is unknown {} left out. ", plural(count, "reading"), what,
                     count == 1 ? "is" : "are");
}

std::string radius_note(const Study& study) {
  std::string note = fmt::format(
      "The nose radius is not known: the report's own simulations suggest {:.2f} in, and the strains on the "
      "plate favour {:.2f} in; the band covers {} to {} in. ",
      study.radius.of_the_report_in(), study.radius.favoured_in(), brief(min_radius_in),
      brief(greatest_radius_in));
  const auto without_figures = std::ranges::count_if(study.on_curves, [&](const Prediction& prediction) {
    return prediction.program == Program::printed_1984 && !prediction.peak_force_lb &&
           prediction.setup.radius_in == study.radius.of_the_report_in();
  });
  if (without_figures > 0)
    note += fmt::format(
        "Runs of the 1984 program that end in an ABEND before reaching a peak are left out ({} in all). ",
        without_figures);
  return note;
}

}  // namespace dashpad::report1986
