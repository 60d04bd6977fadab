#include "input/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/disk.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/spelling.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

using Kind = TomlNode::Kind;
constexpr std::size_t longest_text = 2000;  // bytes

/// Whether a key suggests an oblique impact, which the model does not have.
bool asks_for_oblique_blow(const std::string& key) {
  constexpr std::string_view keys[] = {
      "angle",       "angle_deg",          "angle_rad",      "angle_of_impact",      "angle_of_incidence",
      "incidence",   "incidence_angle",    "impact_angle",   "anvil_angle",          "pad_angle",
      "inclination", "inclination_angle",  "oblique",        "oblique_angle",        "obliquity",
      "tilt",        "tilt_angle",         "velocity_angle", "friction_coefficient", "tangential_speed",
      "slope_angle", "tangential_velocity"};
  return std::ranges::count(keys, lower_case(key)) > 0;
}

constexpr const char* no_oblique_blow =
    "impacts must be normal to the pad; oblique impacts are not supported. Using only the normal component "
    "of the speed neglects friction on the pad, the resulting rotation of the head, and the larger "
    "contact area of a sliding nose";

constexpr std::size_t max_numbers = 2000;

template <class Read>
std::optional<std::vector<double>> read_list(TableReader& table, const std::string& key, std::size_t most,
                                             Read&& read) {
  const TomlNode* list = table.array(key);
  if (!list) return std::nullopt;
  if (list->children.size() > most) {
    table.fault(key, fmt::format("has {} entries; at most {} are allowed", list->children.size(), most));
    return std::nullopt;
  }
  std::vector<double> values;
  for (const TomlNode& entry : list->children) values.push_back(read(entry, table.full_key(key) + entry.key));
  return values;
}

constexpr const char* option = "--set";  ///< stands for a file in faults of settings

/// Further faults have no excerpt, since each one costs a search through the file.
constexpr std::size_t max_excerpts = 1000;

}  // namespace

double read_quantity(const TomlNode& node, const std::string& key, const std::string& si_unit,
                     FaultList& faults) {
  const bool has_text = node.kind == Kind::text || node.kind == Kind::number;
  const auto [value, rule] = read_stated(has_text ? node.text : "", si_unit);
  if (!rule.empty())
    faults.add(node, key, rule);
  else if (node.kind != Kind::text)
    faults.add(node, key, "must be text in quotes");
  else
    return value;
  return no_value;
}

double read_value(const TomlNode& node, const std::string& key, const std::string& unit, FaultList& faults) {
  if (unit != "1") return read_quantity(node, key, unit, faults);
  if (node.kind == Kind::number && std::isfinite(node.number)) return node.number;
  faults.add(node, key,
             node.kind == Kind::number ? "must be a finite number"
                                       : "must be a plain number, without quotes or a unit");
  return no_value;
}

std::optional<std::array<double, 2>> read_pair(const TomlNode& node, const std::string& key,
                                               const std::array<const char*, 2>& units, const char* rule,
                                               FaultList& faults) {
  if (node.kind == Kind::array && node.children.size() == 2)
    return std::array{read_quantity(node.children[0], key, units[0], faults),
                      read_quantity(node.children[1], key, units[1], faults)};
  faults.add(node, key, rule);
  return std::nullopt;
}

const TomlNode* TableReader::find(const std::string& key, Presence presence) {
  if (!std::ranges::count(known_, key)) known_.push_back(key);
  const TomlNode* node = table_->child(key);
  if (!node && presence == Presence::required) faults_->add(table_->line, full_key(key), "", "is missing");
  return node;
}

double TableReader::quantity(const std::string& key, const std::string& si_unit) {
  const TomlNode* node = find(key);
  return node ? read_quantity(*node, full_key(key), si_unit, *faults_) : no_value;
}

double TableReader::value(const std::string& key, const std::string& unit) {
  const TomlNode* node = find(key);
  return node ? read_value(*node, full_key(key), unit, *faults_) : no_value;
}

std::optional<double> TableReader::whole_number(const std::string& key, double lowest, double highest) {
  const double value = number(key);
  if (value >= lowest && value <= highest && value == std::floor(value)) return value;
  if (!std::isnan(value))
    fault(key, fmt::format("must be a whole number from {:.0f} to {:.0f}", lowest, highest));
  return std::nullopt;
}

std::string TableReader::text(const std::string& key, Presence presence) {
  const TomlNode* node = find(key, presence);
  if (!node) return {};
  if (node->kind == Kind::text && !node->text.empty() && node->text.size() <= longest_text) return node->text;
  fault(key, node->kind != Kind::text ? "must be text in quotes"
             : node->text.empty()     ? "must not be empty"
                                      : "must not be longer than " + std::to_string(longest_text) + " bytes");
  return {};
}

std::string TableReader::choice(const std::string& key, const std::vector<std::string>& choices) {
  std::string chosen = text(key);
  if (chosen.empty() || std::ranges::count(choices, chosen)) return chosen;
  fault(key, "must be one of " + listing(choices) + did_you_mean(chosen, choices));
  return {};
}

bool TableReader::yes_or_no(const std::string& key) {
  if (!has(key)) {
    fault(key, "is missing; must be true or false");
    return false;
  }
  const TomlNode& node = *find(key, Presence::optional);
  const bool is_other = node.kind == Kind::other;
  if (!is_other || (node.text != "true" && node.text != "false")) fault(key, "must be true or false");
  return is_other && node.text == "true";
}

std::optional<std::filesystem::path> TableReader::file(const std::string& key,
                                                       const std::filesystem::path& folder) {
  const std::string name = text(key);
  if (name.empty()) return std::nullopt;
  if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; })) {
    fault(key, "the path contains a control character");
    return std::nullopt;
  }
  std::filesystem::path named = folder / name;
  if (is_there(named)) return named;
  fault(key, "no such file: " + named.string());
  return std::nullopt;
}

std::optional<TableReader> TableReader::table(const std::string& key, Presence presence) {
  const TomlNode* node = find(key, presence);
  if (!node) return std::nullopt;
  if (node->kind == Kind::table) return TableReader(*node, full_key(key), *faults_);
  fault(key, "must be a table: [" + full_key(key) + "]");
  return std::nullopt;
}

const TomlNode* TableReader::array(const std::string& key) {
  const TomlNode* node = find(key);
  if (!node || node->kind == Kind::array) return node;
  fault(key, "must be an array in square brackets");
  return nullptr;
}

void TableReader::fault(const std::string& key, std::string rule) {
  const TomlNode* node = table_->child(key);
  if (node)
    faults_->add(*node, full_key(key), std::move(rule));
  else
    faults_->add(table_->line, full_key(key), "", std::move(rule));
}

void TableReader::refuse_others() {
  for (const TomlNode& entry : table_->children) {
    if (std::ranges::count(known_, entry.key)) continue;
    const std::string meant = did_you_mean(entry.key, known_);
    faults_->add_key(entry, full_key(entry.key),
                     asks_for_oblique_blow(entry.key)
                         ? no_oblique_blow
                         : "unknown key" + (meant.empty() ? "; valid keys: " + listing(known_) : meant));
  }
}

std::optional<std::vector<double>> read_numbers(TableReader& table, const std::string& key, double scale) {
  return read_list(table, key, max_numbers, [&](const TomlNode& entry, const std::string& full) {
    const bool is_number = entry.kind == TomlNode::Kind::number;
    const std::string rule = is_number ? rule_of(stated_magnitudes, entry.number, "1") : "must be a number";
    if (rule.empty()) return scale * entry.number;
    table.faults().add(entry, full, rule);
    return no_value;
  });
}

std::optional<std::vector<double>> read_quantities(TableReader& table, const std::string& key,
                                                   const std::string& si_unit, std::size_t most) {
  return read_list(table, key, most, [&](const TomlNode& entry, const std::string& full) {
    return read_quantity(entry, full, si_unit, table.faults());
  });
}

void FaultList::add(int line, TomlNode::Columns columns, std::string key, std::string value,
                    std::string rule) {
  const bool is_set = line == set_by_option;
  faults_.push_back({is_set ? option : file_->name,
                     is_set ? 0 : line,
                     std::move(key),
                     std::move(value),
                     std::move(rule),
                     {}});
  if (faults_.size() <= max_excerpts) faults_.back().excerpt = excerpt_of(file_->text, line, columns);
}

void FaultList::add(const std::vector<Violation>& violations) {
  for (const Violation& violation : violations) {
    if (explains(violation.key)) continue;
    const TomlNode& node = file_->root.nearest(violation.key);
    std::string value = node.written();
    if (value.empty()) value = fmt::format("{}", violation.value);
    add(node.line, node.columns, violation.key, std::move(value), violation.rule);
  }
}

bool FaultList::explains(std::string_view key) const {
  return std::ranges::any_of(faults_, [&](const Fault& fault) {
    return (fault.file == file_->name || fault.file == option) && !fault.key.empty() &&
           key.starts_with(fault.key) &&
           (key.size() == fault.key.size() || key[fault.key.size()] == '.' || key[fault.key.size()] == '[');
  });
}

void FaultList::sort() {
  const auto place = [this](const Fault& fault) { return std::pair(fault.file != file_->name, fault.line); };
  std::ranges::stable_sort(faults_, {}, place);
}

}  // namespace dashpad::input
