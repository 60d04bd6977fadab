// [[impacts]] of a fit file, and the values in it.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "dashpad/fit/fit.hpp"
#include "dashpad/input/case_file.hpp"
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

std::string with_keys(std::string rule) {
  for (auto at = rule.find("--"); at != std::string::npos; at = rule.find("--", at)) {
    rule.erase(at, 2);
    for (; at < rule.size() && (std::islower(static_cast<unsigned char>(rule[at])) || rule[at] == '-'); ++at)
      if (rule[at] == '-') rule[at] = '_';
  }
  return rule;
}

namespace {

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

}  // namespace

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

}  // namespace dashpad::fit
