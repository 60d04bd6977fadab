// [[impacts]] of a fit file with their pulses.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "fit/fit_tables.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;

namespace {

constexpr std::size_t fewest_samples = 5;  ///< between onset and end

input::PulseCsvOptions read_pulse_columns(TableReader& table) {
  input::PulseCsvOptions options;
  if (auto names = table.table("columns", Presence::optional)) {
    if (names->has("time")) options.time = names->text("time");
    if (names->has("acceleration")) options.acceleration = {names->text("acceleration")};
    names->refuse_others();
  }
  options.time_unit = table.text("time_unit", Presence::optional);
  options.acceleration_unit = table.text("acceleration_unit", Presence::optional);
  return options;
}

std::optional<injury::PulseFilter> read_filter(TableReader& table) {
  if (!table.has("filter")) return std::nullopt;
  const std::string name = table.choice("filter", {"CFC60", "CFC180", "CFC600", "CFC1000"});
  if (name.empty()) return std::nullopt;
  return injury::PulseFilter{.channel_frequency_class = std::stoi(name.substr(3))};
}

/// Which impact was measured: the case beside it may be of another.
std::optional<injury::MeasuredImpact> read_impact_of_pulse(TableReader& table) {
  const auto positive = [&](const char* key, const char* unit) -> std::optional<double> {
    if (!table.has(key)) return std::nullopt;
    const double value = table.quantity(key, unit);
    if (value <= 0) table.fault(key, "must be more than 0");
    return value > 0 ? std::optional{value} : std::nullopt;
  };
  const std::optional<double> speed = positive("speed", "m/s"), height = positive("drop_height", "m");
  if (speed && height) table.fault("drop_height", "give speed or drop_height, not both");
  if (height) return injury::after_fall(*height);
  return speed ? std::optional{injury::MeasuredImpact{.speed = *speed}} : std::nullopt;
}

MeasuredFigure read_figure(TableReader& table, const ImpactFigureName& name) {
  MeasuredFigure figure{name.figure, 0, 0};
  figure.value = value_in(table, "value", name.quantity->si_unit);
  if (figure.value < 0)
    table.fault("value", "must not be below 0: all figures are magnitudes");
  else if (std::isfinite(figure.value))
    if (std::string rule =
            rule_of(measured_magnitudes(name.quantity->si_unit), figure.value, name.quantity->si_unit);
        !rule.empty())
      table.fault("value", std::move(rule));
  figure.deviation = value_or_share(table, "deviation", name.quantity->si_unit, figure.value);
  table.refuse_others();
  return figure;
}

}  // namespace

MeasuredDeceleration deceleration_of(const Pulse& measured, const std::optional<injury::Stretch>& quiet) {
  const injury::PulseShape shape =
      injury::pulse_shape(measured, std::nullopt, injury::contact_of(measured, quiet));
  if (!shape.onset)
    throw std::invalid_argument(
        fmt::format("its first sample is above {:.0f} % of its peak already, so that its onset is not in it",
                    100 * injury::onset_share));
  MeasuredDeceleration result;
  result.peak = shape.peak.magnitude;
  result.onset = *shape.onset;
  result.half_peak_width = shape.width;
  result.interval =
      (measured.time.back() - measured.time.front()) / static_cast<double>(measured.time.size() - 1);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < measured.time.size(); ++i)
    if (measured.time[i] >= *shape.onset && measured.time[i] <= shape.contact.end) kept.push_back(i);
  if (kept.size() < fewest_samples)
    throw std::invalid_argument(fmt::format("has {} samples between its onset and its end; a fit needs {}",
                                            kept.size(), fewest_samples));
  result.samples = kept.size();
  Pulse between;
  for (const std::size_t i : kept) {
    between.time.push_back(measured.time[i]);
    between.acceleration.push_back(measured.acceleration[i]);
  }
  result.hic = injury::hic(between, injury::unlimited_window).value;
  result.velocity_change = shape.contact.velocity_change;
  const std::size_t points = std::min(kept.size(), most_pulse_points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t i = kept[k * (kept.size() - 1) / (points - 1)];
    result.time.push_back(measured.time[i] - *shape.onset);
    result.deceleration.push_back(shape.side * measured.acceleration[i]);
  }
  return result;
}

std::optional<MeasuredDeceleration> read_pulse(TableReader& table, const input::Folders& folders,
                                               std::vector<input::InputFile>& files) {
  const std::string name = table.text("file");
  const input::PulseCsvOptions options = read_pulse_columns(table);
  const std::optional<injury::PulseFilter> filter = read_filter(table);
  std::optional<MeasuredDeceleration> pulse;
  if (!name.empty()) {
    const std::filesystem::path file = folders.of_file / name;
    files.push_back({"the measurements", file});
    if (auto read = table.faults().take(input::read_pulse_csv(file, options))) try {
        injury::MeasuredPulse& measured = read->measured;
        const std::optional<injury::SensorOffset> offset = injury::offset_before_impact(measured);
        if (offset && offset->rest) injury::leave_out_before(measured, offset->begin);
        const Pulse processed = injury::processed_pulse(measured, std::nullopt, filter).pulse;
        pulse = offset ? deceleration_of(processed, injury::Stretch{offset->begin, offset->end})
                       : deceleration_of(processed);
        pulse->file = name;
        pulse->filter = filter;
      } catch (const std::invalid_argument& error) {
        table.fault("file", error.what());
      }
  }
  const std::optional<injury::MeasuredImpact> impact = read_impact_of_pulse(table);
  if (pulse) pulse->impact = impact;
  const double value = value_or_share(table, "deviation", "m/s2", pulse ? pulse->peak : 1);
  if (pulse) pulse->deviation = value;
  table.refuse_others();
  return pulse;
}

ImpactMeasurement read_impact(TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files) {
  ImpactMeasurement impact;
  impact.file = table.text("case");
  if (!impact.file.empty()) {
    if (auto read = table.faults().take(input::read_case(folders.of_file / impact.file, folders.materials))) {
      impact.impact = std::move(read->impact);
      impact.options = read->options;
      impact.states_neighbours = read->states_neighbours;
      std::ranges::move(read->files, std::back_inserter(files));
    }
  }
  for (const ImpactFigureName& name : impact_figure_names())
    if (auto figure = table.table(name.key, Presence::optional))
      impact.figures.push_back(read_figure(*figure, name));
  if (auto pulse = table.table("pulse", Presence::optional))
    impact.pulse = read_pulse(*pulse, folders, files);
  impact.is_held_out = table.flag("hold_out");
  table.refuse_others();
  return impact;
}

}  // namespace dashpad::fit
