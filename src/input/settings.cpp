#include "input/case_tables.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "input/spelling.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t longest_setting = 1000;

/// Keys of a case that a material replaces.
constexpr std::array of_the_case{"law", "parameters", "curve", "rate", "unloading", "uncertainty"};

/// Removes what cannot stand beside an entry `name` of `table`, which is called `path`.
void make_room(TomlNode& table, std::string_view path, std::string_view name) {
  const auto erase = [&](std::string_view key) {
    std::erase_if(table.children, [&](const TomlNode& toml_node) { return toml_node.key == key; });
  };
  if (name == "material")
    for (const char* key : of_the_case) erase(key);
  const std::string key = fmt::format("{}.{}", path, name);
  for (const OtherWay& way : other_ways())
    if (key == way.key || key == way.instead_of) {
      const std::string_view other = key == way.key ? way.instead_of : way.key;
      erase(other.substr(other.find('.') + 1));
    }
}

std::vector<std::string> parts_of(std::string_view key) {
  std::vector<std::string> parts;
  while (!key.empty()) parts.emplace_back(take_key_part(key));
  return parts;
}

/// Whether a number is held by a card, by the table two levels above it.
bool is_of_card(const TomlNode& above, std::string_view table) {
  return above.child("material") != nullptr && (table == "parameters" || table == "curve" || table == "rate");
}

enum class Put { done, waits_for_case, refused };

/// Puts a value at the end of a path, or sets the `rule` that the key breaks.
Put put(TomlNode& root, const std::vector<std::string>& path, TomlNode value, std::string& rule) {
  const auto refuse = [&rule](std::string why) {
    rule = std::move(why);
    return Put::refused;
  };
  TomlNode* at = &root;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (i + 2 == path.size() && is_of_card(*at, path[i])) return Put::waits_for_case;
    TomlNode* next = at->child(path[i]);
    if (next == nullptr && at->kind == TomlNode::Kind::array)
      return refuse(fmt::format("there is no such entry; the last is number {}", at->children.size()));
    if (next == nullptr) {
      at->children.push_back({.kind = TomlNode::Kind::table, .line = set_by_option, .key = path[i]});
      next = &at->children.back();
    }
    if (next->kind != TomlNode::Kind::table && next->kind != TomlNode::Kind::array)
      return refuse(fmt::format("{} is a value, not a table", path[i]));
    at = next;
  }
  make_room(*at, path.front(), path.back());
  value.key = path.back();
  if (TomlNode* there = at->child(path.back()))
    *there = std::move(value);
  else if (at->kind == TomlNode::Kind::array)
    return refuse(fmt::format("there is no such entry; the last is number {}", at->children.size()));
  else
    at->children.push_back(std::move(value));
  return Put::done;
}

/// The material to which a key such as pad.layers[2].curve.modulus belongs; null for other keys.
Material* material_of(std::string_view key, ImpactCase& impact) {
  const auto is_number_of = [&](std::string_view pad) {
    return key.starts_with(pad) &&
           std::ranges::any_of(std::array{".parameters.", ".curve.", ".rate."}, [&](std::string_view table) {
             return key.substr(pad.size()).starts_with(table);
           });
  };
  for (std::size_t i = 0; i < impact.pad.layers.size(); ++i)
    if (is_number_of(fmt::format("pad.layers[{}]", i + 1))) return &impact.pad.layers[i].material;
  return is_number_of("pad") ? &impact.pad.material : nullptr;
}

}  // namespace

std::vector<LaterSetting> put_settings(const std::vector<std::string>& settings, TomlNode& root,
                                       FaultList& faults) {
  std::vector<LaterSetting> later;
  for (const std::string& setting : settings) {
    const auto sign = std::min(setting.find('='), setting.size());
    const std::string key = setting.substr(0, sign);
    const std::string value = sign < setting.size() ? setting.substr(sign + 1) : "";
    if (key.empty() || value.empty() || setting.size() > longest_setting) {
      faults.add(set_by_option, "", "",
                 fmt::format("{} must be KEY=VALUE of at most {} characters, as in pad.thickness=\"30 mm\"",
                             setting.substr(0, 40), longest_setting));
      continue;
    }
    std::string rule;
    const Put way =
        key == "support.scale" ? Put::waits_for_case : put(root, parts_of(key), toml_value(value), rule);
    if (way == Put::waits_for_case) later.push_back({key, value});
    if (way == Put::refused) faults.add(set_by_option, key, value, rule);
  }
  return later;
}

void put_later(const std::vector<LaterSetting>& settings, ImpactCase& impact, FaultList& faults) {
  if (settings.empty()) return;
  const CaseQuantities quantities = quantities_of(impact);
  std::vector<std::string> keys;
  for (const CaseQuantity& quantity : quantities) keys.push_back(quantity.key);
  for (const auto& [key, value] : settings) {
    const CaseQuantity* const found = quantities.find(key);
    if (found == nullptr) {
      faults.add(set_by_option, key, value, "is not a numeric key of this case" + did_you_mean(key, keys));
      continue;
    }
    auto [number, rule] = read_stated(value, found->unit);
    if (rule.empty() && key.starts_with("support.") && number <= 0) rule = "must be more than 0";
    if (!rule.empty()) {
      faults.add(set_by_option, key, value, rule);
      continue;
    }
    found->set(impact, number);
    // The name of the card stands for other numbers.
    if (Material* material = material_of(key, impact))
      material->name += fmt::format(" with {} = {}", key.substr(key.rfind('.') + 1), value);
  }
  for (const Violation& violation : violations(impact))
    for (const auto& [key, value] : settings)
      if (violation.key == key) faults.add(set_by_option, key, value, violation.rule);
}

}  // namespace dashpad::input
