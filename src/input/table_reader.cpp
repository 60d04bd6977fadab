#include "input/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dashpad/quantities/quantity.hpp"
#include "input/spelling.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

using Kind = TomlNode::Kind;
constexpr std::size_t longest_text = 2000;  // bytes; a title, a source or a note of a page is no text of use
constexpr double missing_number = std::numeric_limits<double>::quiet_NaN();

/// Whether one would ask by it for an oblique blow, which the model does not have: of the impactor, or of the
/// pad or the anvil that is set at an angle.
bool asks_for_oblique_blow(std::string key) {
  constexpr std::string_view keys[] = {
      "angle",       "angle_deg",          "angle_rad",      "angle_of_impact",      "angle_of_incidence",
      "incidence",   "incidence_angle",    "impact_angle",   "anvil_angle",          "pad_angle",
      "inclination", "inclination_angle",  "oblique",        "oblique_angle",        "obliquity",
      "tilt",        "tilt_angle",         "velocity_angle", "friction_coefficient", "tangential_speed",
      "slope_angle", "tangential_velocity"};
  std::ranges::transform(key, key.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::ranges::count(keys, key) > 0;
}

constexpr const char* no_oblique_blow =
    "blows are along the normal of the pad: there is no oblique blow; with the normal part of the speed "
    "alone, friction on the pad, the turning of the head that it brings about, and the larger contact of a "
    "nose that slides are left out";

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
  return missing_number;
}

TableReader::TableReader(const TomlNode& table, std::string path, FaultList& faults)
    : table_(&table), path_(std::move(path)), faults_(&faults) {}

const TomlNode* TableReader::find(const std::string& key, Presence presence) {
  if (!std::ranges::count(known_, key)) known_.push_back(key);
  const TomlNode* node = table_->child(key);
  if (!node && presence == Presence::required) faults_->add(table_->line, full_key(key), "", "is missing");
  return node;
}

double TableReader::quantity(const std::string& key, const std::string& si_unit) {
  const TomlNode* node = find(key, Presence::required);
  return node ? read_quantity(*node, full_key(key), si_unit, *faults_) : missing_number;
}

double TableReader::number(const std::string& key) {
  const TomlNode* node = find(key, Presence::required);
  if (!node) return missing_number;
  if (node->kind == Kind::number && std::isfinite(node->number)) return node->number;
  fault(key, node->kind == Kind::number ? "must be a finite number"
                                        : "must be a plain number, without quotes and unit");
  return missing_number;
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

std::optional<TableReader> TableReader::table(const std::string& key, Presence presence) {
  const TomlNode* node = find(key, presence);
  if (!node) return std::nullopt;
  if (node->kind == Kind::table) return TableReader(*node, full_key(key), *faults_);
  fault(key, "must be a table: [" + full_key(key) + "]");
  return std::nullopt;
}

const TomlNode* TableReader::array(const std::string& key) {
  const TomlNode* node = find(key, Presence::required);
  if (!node || node->kind == Kind::array) return node;
  fault(key, "must be an array in square brackets");
  return nullptr;
}

bool TableReader::has(const std::string& key) { return find(key, Presence::optional) != nullptr; }

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
                         : "unknown key" + (meant.empty() ? "; known here are " + listing(known_) : meant));
  }
}

}  // namespace dashpad::input
