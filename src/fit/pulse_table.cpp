// The whole pulse of an impact in a fit file.

#include <algorithm>
#include <stdexcept>

#include "dashpad/input/measurement/pulse_csv.hpp"
#include "fit/fit_tables.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;

namespace {

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

}  // namespace

std::optional<MeasuredDeceleration> read_pulse(TableReader& table, const FitFolders& folders,
                                               std::vector<input::InputFile>& files) {
  const std::string name = table.text("file");
  const input::PulseCsvOptions options = read_pulse_columns(table);
  const std::optional<injury::PulseFilter> filter = read_filter(table);
  std::optional<MeasuredDeceleration> pulse;
  if (!name.empty()) {
    const std::filesystem::path file = folders.of_fit / name;
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

}  // namespace dashpad::fit
