#include "report1986/validation_series.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "quantities/text.hpp"

namespace dashpad::report1986 {

namespace {

std::size_t turn_of(Program program) {
  switch (program) {
    case Program::printed_1984: return turn::printed_1984;
    case Program::mended_support_1984: return turn::mended_1984;
    case Program::accurate: return turn::accurate;
    case Program::accurate_first_slope: return turn::first_slope;
  }
  return 0;
}

/// What the runs at one speed give.
struct AtSpeed {
  std::optional<double> favoured, of_the_report;
  double low = HUGE_VAL, high = -HUGE_VAL;
};

std::map<double, AtSpeed> by_speed(const Study& study, Program program, TestGroup group, Quantity quantity) {
  std::map<double, AtSpeed> speeds;
  for (const Prediction& prediction : study.on_curves) {
    const Setup& setup = prediction.setup;
    if (prediction.program != program || setup.projectile != group.projectile ||
        setup.support != group.support)
      continue;
    const std::optional<double> value = predicted(prediction, quantity);
    if (!value) continue;
    AtSpeed& at = speeds[setup.speed_mph];
    if (setup.radius_in == study.radius.favoured_in()) at.favoured = value;
    if (setup.radius_in == study.radius.of_the_report_in()) at.of_the_report = value;
    at.low = std::min(at.low, *value);
    at.high = std::max(at.high, *value);
  }
  return speeds;
}

output::Series over_speed(const std::map<double, AtSpeed>& speeds, std::optional<double> AtSpeed::*value) {
  output::Series series;
  for (const auto& [speed, at] : speeds) {
    if (!(at.*value)) continue;
    series.x.push_back(speed);
    series.y.push_back(*(at.*value));
  }
  return series;
}

}  // namespace

std::string axis_label(Quantity quantity) {
  switch (quantity) {
    case Quantity::peak_force: return "Peak force (lb)";
    case Quantity::time_to_peak: return "Time to peak force (ms)";
    case Quantity::rebound_speed: return "Rebound speed (mph)";
    case Quantity::peak_strain: return "Peak strain (1)";
  }
  return "";
}

output::Series measured_points(const Study& study, TestGroup group, Quantity quantity,
                               const std::string& label, std::size_t turn) {
  output::Series points{.label = label, .style = output::SeriesStyle::points, .turn = turn};
  for (const MeasuredTest& test : study.data.measured.tests) {
    const std::optional<double> value = measured(test, quantity);
    if (!value || test.projectile != group.projectile || test.support != group.support) continue;
    points.x.push_back(test.speed_mph);
    points.y.push_back(*value);
  }
  return points;
}

std::vector<output::Series> predicted_lines(const Study& study, Program program, TestGroup group,
                                            Quantity quantity) {
  const auto speeds = by_speed(study, program, group, quantity);
  const double of_the_report = study.radius.of_the_report_in(), favoured = study.radius.favoured_in();
  const auto label = [&](double radius) { return fmt::format("{}, {:.2f} in", to_string(program), radius); };
  output::Series line = over_speed(speeds, &AtSpeed::of_the_report);
  line.label = label(of_the_report);
  line.style = output::SeriesStyle::points;  // the program of 1984: many of its runs end in an ABEND
  if (program == Program::accurate) line.style = output::SeriesStyle::solid_line;
  if (program == Program::accurate_first_slope) line.style = output::SeriesStyle::line;
  line.turn = turn_of(program);
  if (program != Program::accurate) return {line};

  output::Series band{.label = std::string{to_string(program)} + ", over the nose radii",
                      .style = output::SeriesStyle::band,
                      .turn = line.turn};
  for (const auto& [speed, at] : speeds) {
    band.x.push_back(speed);
    band.y.push_back(at.low);
    band.y2.push_back(at.high);
  }
  output::Series dashed = over_speed(speeds, &AtSpeed::favoured);
  dashed.label = label(favoured);
  dashed.style = output::SeriesStyle::dashed_line;
  dashed.turn = line.turn;
  if (favoured == of_the_report) return {band, line};
  return {band, line, dashed};
}

std::vector<output::Series> predicted_lines(const Study& study, const std::vector<Program>& shown,
                                            TestGroup group, Quantity quantity) {
  std::vector<output::Series> all;
  for (const Program program : shown)
    for (output::Series& series : predicted_lines(study, program, group, quantity))
      all.push_back(std::move(series));
  return all;
}

output::Series function_line(const std::string& label, std::size_t turn, double low, double high,
                             const std::function<double(double)>& value, output::SeriesStyle style) {
  constexpr int steps = 100;
  output::Series line{.label = label, .style = style, .turn = turn};
  for (int i = 0; i <= steps; ++i) {
    line.x.push_back(low + (high - low) * i / steps);
    line.y.push_back(value(line.x.back()));
  }
  return line;
}

const FittedConstant* fitted(const Study& study, const std::string& name) {
  const auto found = std::ranges::find(study.constants, name, &FittedConstant::name);
  return found == study.constants.end() ? nullptr : &*found;
}

const MeasuredTest& test_of(const Study& study, int number) {
  const auto found = std::ranges::find(study.data.measured.tests, number, &MeasuredTest::number);
  if (found == study.data.measured.tests.end())
    throw std::out_of_range(fmt::format("there is no test {}", number));
  return *found;
}

std::string source_line(const std::string& where) {
  return fmt::format("Crash Padding Research, Volume III (1986), {}; dashpad {}", where, version());
}

std::string lost_readings(const Study& study, const std::vector<std::string>& columns,
                          const std::string& what) {
  std::size_t count = 0;
  for (const UnplacedReadings& group : study.data.measured.unplaced)
    if (std::ranges::find(columns, group.column) != columns.end()) count += group.readings.size();
  if (count == 0) return "";
  return fmt::format("{} {} of {} whose test the scan lost {} left out. ", count,
                     count == 1 ? "reading" : "readings", what, count == 1 ? "is" : "are");
}

std::string radius_note(const Study& study) {
  std::string note = fmt::format(
      "The nose radius is lost: {:.2f} in is what the report's own simulations point to, {:.2f} in what the "
      "strains on the plate favour; the band spans {} to {} in. ",
      study.radius.of_the_report_in(), study.radius.favoured_in(), brief(least_radius_in),
      brief(greatest_radius_in));
  const auto without_figures = std::ranges::count_if(study.on_curves, [&](const Prediction& prediction) {
    return prediction.program == Program::printed_1984 && !prediction.peak_force_lb &&
           prediction.setup.radius_in == study.radius.of_the_report_in();
  });
  if (without_figures > 0)
    note +=
        fmt::format("{} runs of the 1984 program end in an ABEND before they have a peak and are left out. ",
                    without_figures);
  return note;
}

}  // namespace dashpad::report1986
