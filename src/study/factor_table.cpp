#include "study/factor_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "dashpad/study/design.hpp"
#include "input/spelling.hpp"

namespace dashpad::study {
namespace {

/// What cannot be judged while a factor is not known.
const std::vector<std::string> keys_about_all_factors{"factors", "samples", "indices"};

constexpr std::size_t most_materials = 1000;

struct Entry {
  std::string key;
  const input::TomlNode* node;
};

/// [factors."impactor.speed"] and [factors.impactor.speed] mean the same. A table that is on the way to a
/// known key is opened; every other one is a factor.
void collect(const input::TomlNode& table, const std::string& prefix, const std::vector<std::string>& known,
             std::vector<Entry>& entries) {
  for (const input::TomlNode& child : table.children) {
    const std::string key = prefix + child.key;
    const auto on_the_way = [&](const std::string& of) { return of.starts_with(key + "."); };
    if (child.kind == input::TomlNode::Kind::table && std::ranges::any_of(known, on_the_way))
      collect(child, key + ".", known, entries);
    else
      entries.push_back({key, &child});
  }
}

/// Absent after a fault.
std::optional<Material> read_named(const input::TomlNode& entry, const std::string& key,
                                   const input::Folders& folders, input::FaultList& faults) {
  const std::string& name = entry.text;
  if (entry.kind != input::TomlNode::Kind::text || name.empty()) {
    faults.add(entry, key, "must be the name of a card or a .toml file in quotes");
    return std::nullopt;
  }
  if (name.ends_with(".toml")) return faults.take(input::read_material(folders.of_file / name));
  const auto cards = faults.take(input::list_materials(folders.materials));
  if (!cards) return std::nullopt;
  for (const auto& card : *cards)
    if (card.stem() == name) return faults.take(input::read_material(card));
  faults.add(entry, key, input::no_such("card", name, folders.materials, *cards));
  return std::nullopt;
}

/// A material that cannot be read keeps its place as the base case's.
Levels read_materials(input::TableReader& table, const input::Folders& folders, Study& study) {
  Levels levels;
  const input::TomlNode* list = table.array("values");
  if (!list) return levels;
  if (list->children.empty() || list->children.size() > most_materials) {
    table.fault("values", fmt::format("must hold 1 to {} materials", most_materials));
    return levels;
  }
  for (const input::TomlNode& entry : list->children) {
    const auto material = read_named(entry, table.full_key("values") + entry.key, folders, table.faults());
    if (!material) continue;
    levels.values.push_back(static_cast<double>(study.materials.size()));
    study.materials.push_back(*material);
  }
  return levels;
}

Factor read_factor(const FactorKey& key, input::TableReader& table, const input::Folders& folders,
                   Study& study) {
  Factor factor{.key = key.key, .unit = key.unit, .spread = Levels{}, .lowest = {}, .highest = {}};
  if (key.key == "pad.material") {
    factor.spread = read_materials(table, folders, study);
  } else {
    factor.spread = read_spread(table, key.unit, folders);
    if (table.has("lowest")) factor.lowest = table.value("lowest", key.unit);
    if (table.has("highest")) factor.highest = table.value("highest", key.unit);
  }
  return factor;
}

/// What can vary.
struct Known {
  const std::vector<FactorKey>& keys;
  bool has_base;
};

/// False if the factor cannot be judged further.
bool read_entry(const Entry& entry, const std::string& path, const Known& known,
                const input::Folders& folders, input::FaultList& faults, Study& study) {
  const auto& [key, node] = entry;
  const auto found = std::ranges::find(known.keys, key, &FactorKey::key);
  if (found == known.keys.end()) {
    const bool on_trust = !known.has_base && (is_of_law(key) || key.starts_with("support."));
    if (!on_trust) faults.add(*node, path, rule_for_unknown(key, study.base));
    return false;
  }
  if (node->kind != input::TomlNode::Kind::table) {
    faults.add(*node, path, "must be a table: [factors.\"" + key + "\"]");
    return false;
  }
  input::TableReader reader(*node, path, faults);
  const std::size_t before = faults.size();
  study.factors.push_back(read_factor(*found, reader, folders, study));
  const bool good = faults.size() == before;
  reader.refuse_others();
  return good;
}

}  // namespace

FactorLines read_factors(input::TableReader& top, bool has_base, const input::Folders& folders,
                         Study& study) {
  FactorLines lines;
  const auto table = top.table("factors");
  if (!table) {
    lines.at_fault = keys_about_all_factors;
    return lines;
  }
  const std::vector<FactorKey> keys = factor_keys(study.base);
  std::vector<std::string> names;
  for (const FactorKey& key : keys) names.push_back(key.key);
  std::vector<Entry> entries;
  collect(table->node(), "", names, entries);
  const Known known{keys, has_base};
  for (const Entry& entry : entries) {
    const std::string path = "factors." + entry.key;
    lines.lines.emplace(path, entry.node->line);
    if (!read_entry(entry, path, known, folders, top.faults(), study)) lines.at_fault.push_back(path);
  }
  if (!lines.at_fault.empty())
    lines.at_fault.insert(lines.at_fault.end(), keys_about_all_factors.begin(), keys_about_all_factors.end());
  return lines;
}

void add_violations(const std::vector<Violation>& broken, const input::TomlNode& root,
                    const FactorLines& lines, input::FaultList& faults) {
  for (const Violation& violation : broken) {
    if (std::ranges::count(lines.at_fault, violation.key)) continue;
    const auto line = lines.lines.find(violation.key);
    if (line != lines.lines.end())
      faults.add(line->second, violation.key, "", violation.rule);
    else if (std::isnan(violation.value) && root.nearest(violation.key).written().empty())
      faults.add(root.nearest(violation.key).line, violation.key, "", violation.rule);
    else
      faults.add({violation});
  }
}

}  // namespace dashpad::study
