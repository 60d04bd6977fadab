// The pulse of an impact in a fit file: its file, and what is made of it.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "fit/fit_tables.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;
using input::TomlNode;

namespace {

constexpr std::size_t fewest_samples = 5;  ///< between onset and end

/// The texts of an entry that is one text or an array of them.
std::vector<std::string> read_texts(TableReader& table, const std::string& key) {
  const TomlNode* const node = table.find(key, Presence::optional);
  if (!node) return {};
  if (node->kind == TomlNode::Kind::text) return {table.text(key)};
  std::vector<std::string> texts;
  if (node->kind == TomlNode::Kind::array)
    for (const TomlNode& each : node->children)
      if (each.kind == TomlNode::Kind::text) texts.push_back(each.text);
  if (texts.empty() || texts.size() != node->children.size())
    table.fault(key, "must be text in quotes, or an array of such texts");
  return texts;
}

/// Calls `parse` with the text of an optional entry; what it throws is a fault.
template <class Parse>
void read_parsed(TableReader& table, const std::string& key, Parse&& parse) {
  for (const std::string& text : read_texts(table, key)) try {
      parse(text);
    } catch (const UnitError& error) {
      table.fault(key, error.what());
    }
}

/// The options of `dashpad pulse` that say how a file is read, under the same names.
input::PulseOptions read_source(TableReader& table) {
  input::PulseOptions options;
  if (auto names = table.table("columns", Presence::optional)) {
    if (names->has("time")) options.time = names->text("time");
    options.acceleration = read_texts(*names, "acceleration");
    names->refuse_others();
  }
  for (const auto& [key, text] : {std::pair{"time_unit", &options.time_unit},
                                  {"acceleration_unit", &options.acceleration_unit},
                                  {"channel", &options.channel},
                                  {"test", &options.test}})
    *text = table.text(key, Presence::optional);
  options.resultant = table.flag("resultant");
  options.bridge_gaps = table.flag("bridge_gaps");
  read_parsed(table, "sensitivity",
              [&](const std::string& text) { options.sensitivity.push_back(input::sensitivity_of(text)); });
  const auto time = [&](const char* key) {
    return table.has(key) ? std::optional{table.quantity(key, "s")} : std::nullopt;
  };
  options.interval = time("interval");
  if (options.interval && *options.interval <= 0) table.fault("interval", "must be more than 0");
  options.cut = {time("from"), time("to")};
  if (options.cut.from && options.cut.to && *options.cut.from >= *options.cut.to)
    table.fault("to", "must be later than \"from\"");
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

/// The pulse with its offset taken off if that is asked for, resampled if need be, filtered.
MeasuredDeceleration processed_of(injury::MeasuredPulse measured, bool is_zeroed,
                                  const std::optional<std::pair<double, double>>& zero,
                                  const std::optional<injury::PulseFilter>& filter) {
  const std::optional<injury::SensorOffset> offset = injury::find_offset(measured, zero, is_zeroed);
  if (is_zeroed) measured = injury::zeroed(std::move(measured), *offset);
  const std::optional<double> interval = filter ? injury::resampling_for_filter(measured) : std::nullopt;
  if (filter)
    std::ranges::move(injury::filter_remarks(measured, interval, *filter),
                      std::back_inserter(measured.remarks));
  const injury::ProcessedPulse pulse = injury::processed_pulse(measured, interval, filter);
  MeasuredDeceleration deceleration =
      offset ? deceleration_of(pulse, injury::Stretch{offset->begin, offset->end}) : deceleration_of(pulse);
  deceleration.remarks = std::move(measured.remarks);
  return deceleration;
}

}  // namespace

std::optional<MeasuredDeceleration> read_pulse(TableReader& table, const input::Folders& folders,
                                               std::vector<input::InputFile>& files) {
  const std::string name = table.text("file");
  const input::PulseOptions options = read_source(table);
  std::optional<std::pair<double, double>> zero;
  read_parsed(table, "zero", [&](const std::string& text) { zero = input::interval_of_zero(text); });
  const std::optional<injury::PulseFilter> filter = read_filter(table);
  std::optional<MeasuredDeceleration> pulse;
  if (!name.empty()) {
    const std::filesystem::path file = folders.of_file / name;
    if (auto read = taken_with_keys(input::read_pulse(file, options), table.faults())) try {
        std::ranges::move(read->files, std::back_inserter(files));
        pulse = processed_of(std::move(read->measured), table.has("zero"), zero, filter);
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

MeasuredDeceleration deceleration_of(const injury::ProcessedPulse& processed,
                                     const std::optional<injury::Stretch>& quiet) {
  const Pulse& measured = processed.pulse;
  const injury::PulseShape shape =
      injury::pulse_shape(measured, std::nullopt, injury::contact_of(processed.along(), quiet));
  if (!shape.onset)
    throw std::invalid_argument(fmt::format(
        "the first sample is already above {:.0f} % of the peak, so the record does not include the onset",
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
    throw std::invalid_argument(fmt::format("has {} samples from onset to end; a fit needs at least {}",
                                            kept.size(), fewest_samples));
  result.samples = kept.size();
  Pulse between;
  for (const std::size_t i : kept) {
    between.time.push_back(measured.time[i]);
    between.acceleration.push_back(measured.acceleration[i]);
  }
  result.hic = injury::hic(between, injury::unlimited_window).value;
  result.velocity_change = shape.contact.velocity_change;
  const std::size_t points = std::min(kept.size(), max_pulse_points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t i = kept[k * (kept.size() - 1) / (points - 1)];
    result.time.push_back(measured.time[i] - *shape.onset);
    result.deceleration.push_back(shape.side * measured.acceleration[i]);
  }
  return result;
}

}  // namespace dashpad::fit
