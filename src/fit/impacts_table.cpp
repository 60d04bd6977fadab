// [[impacts]] of a fit file with their pulses.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "fit/fit_tables.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;
using input::TomlNode;

double value_of(const TomlNode& node, const std::string& key, const std::string& unit,
                input::FaultList& faults) {
  const bool is_in_g = unit == "m/s2" && node.kind == TomlNode::Kind::text && node.text.ends_with(" g");
  if (!is_in_g) return read_value(node, key, unit, faults);
  TomlNode with_gravity = node;
  with_gravity.text.replace(node.text.size() - 1, 1, "gravity");
  return read_quantity(with_gravity, key, unit, faults);
}

double value_in(TableReader& table, const std::string& key, const std::string& unit) {
  const TomlNode* const node = table.find(key);
  return node ? value_of(*node, table.full_key(key), unit, table.faults()) : no_value;
}

double value_or_share(TableReader& table, const std::string& key, const std::string& unit, double whole) {
  const TomlNode* const node = table.find(key, Presence::optional);
  const bool is_share = node && node->kind == TomlNode::Kind::text && node->text.ends_with('%');
  return is_share ? table.quantity(key, "1") * std::abs(whole) : value_in(table, key, unit);
}

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

/// The keys of a fit in place of the options in a rule: "bridge_gaps" for "--bridge-gaps".
std::string with_keys(std::string rule) {
  for (auto at = rule.find("--"); at != std::string::npos; at = rule.find("--", at)) {
    rule.erase(at, 2);
    for (; at < rule.size() && (std::islower(static_cast<unsigned char>(rule[at])) || rule[at] == '-'); ++at)
      if (rule[at] == '-') rule[at] = '_';
  }
  return rule;
}

/// What was read; faults are added in words of a fit file.
template <class T>
std::optional<T> taken_with_keys(input::Reading<T> reading, input::FaultList& faults) {
  if (reading) return *std::move(reading);
  for (input::Fault fault : reading.faults()) {
    fault.rule = with_keys(std::move(fault.rule));
    faults.add({std::move(fault)});
  }
  return std::nullopt;
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

MeasuredFigure read_figure(TableReader& table, const ImpactFigureName& name) {
  MeasuredFigure figure{name.figure, 0, 0};
  figure.value = value_in(table, "value", name.quantity->si_unit);
  if (figure.value < 0)
    table.fault("value", "must not be negative: all figures are magnitudes");
  else if (std::isfinite(figure.value))
    if (std::string rule =
            rule_of(measured_magnitudes(name.quantity->si_unit), figure.value, name.quantity->si_unit);
        !rule.empty())
      table.fault("value", std::move(rule));
  figure.deviation = value_or_share(table, "deviation", name.quantity->si_unit, figure.value);
  table.refuse_others();
  return figure;
}

input::StressStrainColumns read_columns(TableReader& table) {
  input::StressStrainColumns columns;
  if (auto names = table.table("columns", Presence::optional)) {
    for (const auto& [key, name] :
         {std::pair{"strain", &columns.strain}, {"stress", &columns.stress}, {"time", &columns.time}})
      if (names->has(key)) *name = names->text(key);
    names->refuse_others();
  }
  columns.strain_unit = table.text("strain_unit", Presence::optional);
  columns.stress_unit = table.text("stress_unit", Presence::optional);
  for (const auto& [key, unit, value] :
       {std::tuple{"thickness", "m", &columns.thickness}, {"area", "m2", &columns.area}})
    if (table.has(key)) {
      *value = table.quantity(key, unit);
      if (**value <= 0) table.fault(key, "must be more than 0");
    }
  columns.time_unit = table.text("time_unit", Presence::optional);
  return columns;
}

void read_range(TableReader& table, MaterialMeasurement& test) {
  if (!table.has("range")) return;
  const TomlNode* range = table.array("range");
  if (!range) return;
  const bool sound =
      range->children.size() == 2 &&
      std::ranges::all_of(range->children,
                          [](const TomlNode& node) { return node.kind == TomlNode::Kind::number; }) &&
      range->children[0].number < range->children[1].number && range->children[0].number >= 0 &&
      range->children[1].number <= 1;
  if (!sound) {
    table.fault("range", "must be two strains from 0 to 1, the lower one first, such as [0, 0.5]");
    return;
  }
  test.lowest_strain = range->children[0].number;
  test.highest_strain = range->children[1].number;
}

/// Times of strains that go on at one rate, up or down.
std::vector<double> times_at(double rate, const std::vector<double>& strain) {
  std::vector<double> times{0};
  for (std::size_t i = 1; i < strain.size(); ++i)
    times.push_back(times.back() + std::abs(strain[i] - strain[i - 1]) / rate);
  return times;
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

/// Reads the pulse of an impact, {file = ..., deviation = ...}; none after a fault.
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

}  // namespace

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

std::vector<std::string> settings_in(const TomlNode& set, const std::string& prefix) {
  std::vector<std::string> settings;
  for (const TomlNode& child : set.children)
    if (child.kind == TomlNode::Kind::table)
      std::ranges::move(settings_in(child, prefix + child.key + "."), std::back_inserter(settings));
    else
      settings.push_back(prefix + child.key + "=" + child.text);
  return settings;
}

namespace {

/// The case of an impact with the numbers of `set`; their faults are those of the entry.
std::optional<input::CaseFile> read_case_of(TableReader& table, const std::string& name,
                                            const input::Folders& folders, const Fit& fit) {
  std::vector<std::string> settings;
  const auto set = table.table("set", Presence::optional);
  if (set) settings = settings_in(set->node());
  for (const std::string& setting : settings)
    if (const std::string key = setting.substr(0, setting.find('='));
        std::ranges::count(fit.unknowns, key, &Unknown::key))
      table.faults().add(set->node().line, table.full_key("set") + "." + key, "",
                         "is an unknown of the fit: leave one of them out");
  auto read = input::read_case(folders.of_file / name, folders.materials, settings);
  if (read) return *std::move(read);
  for (input::Fault fault : read.faults())
    if (set && fault.file == "--set")
      table.faults().add(set->node().line, table.full_key("set") + "." + fault.key, fault.value, fault.rule);
    else
      table.faults().add({std::move(fault)});
  return std::nullopt;
}

}  // namespace

void read_impacts(TableReader& table, const input::Folders& folders, std::vector<input::InputFile>& files,
                  Fit& fit) {
  ImpactMeasurement impact;
  impact.file = table.text("case");
  bool has_case = false;
  if (!impact.file.empty()) {
    if (auto read = read_case_of(table, impact.file, folders, fit)) {
      has_case = true;
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
  if (!table.has("rows"))
    fit.impacts.push_back(std::move(impact));
  else if (has_case)
    std::ranges::move(read_drops(table, folders, impact, fit, files), std::back_inserter(fit.impacts));
  else
    (void)table.has("deviation");
  table.refuse_others();
}

MaterialMeasurement read_test(TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files) {
  MaterialMeasurement test;
  test.file = table.text("file");
  const input::StressStrainColumns columns = read_columns(table);
  std::optional<double> rate;
  if (table.has("rate")) {
    rate = table.quantity("rate", "1/s");
    if (*rate <= 0) table.fault("rate", "must be more than 0; the direction follows from the strains");
  }
  if (rate && !columns.time.empty()) table.fault("rate", "give a rate or a time column, not both");
  if (!rate && columns.time.empty())
    table.fault("rate",
                "is missing; give the strain rate of the test, such as \"0.01 1/s\", or name a time column: "
                "columns = {time = \"time\"}");
  read_range(table, test);
  if (table.has("temperature"))
    if (const double temperature = table.quantity("temperature", "K"); std::isfinite(temperature))
      test.temperature = temperature;
  test.has_offset = table.flag("offset");
  test.is_held_out = table.flag("hold_out");
  if (test.has_offset && test.is_held_out)
    table.fault("offset", "an offset cannot be fitted for a test that is held out");
  if (!test.file.empty()) {
    const std::filesystem::path file = folders.of_file / test.file;
    files.push_back({"the measurements", file});
    if (auto read = taken_with_keys(input::read_stress_strain_csv(file, columns), table.faults())) {
      test.strain = std::move(read->strain);
      test.stress = std::move(read->stress);
      test.time = std::move(read->time);
      test.remarks = std::move(read->remarks);
      if (rate && *rate > 0) test.time = times_at(*rate, test.strain);
    }
  }
  if (table.has("noise")) {
    double largest = no_value;
    for (std::size_t i = 0; i < test.stress.size(); ++i)
      if (counts(test, i) && !(test.stress[i] <= largest)) largest = test.stress[i];
    test.noise = value_or_share(table, "noise", "Pa", largest);
  }
  table.refuse_others();
  return test;
}

}  // namespace dashpad::fit
