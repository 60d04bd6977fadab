#include "dashpad/study/study_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "input/spelling.hpp"
#include "study/factor_spread.hpp"

namespace dashpad::study {

namespace {

constexpr double default_tolerance = 1e-3;

/// The lines of the factors in the file.
struct FactorLines {
  std::map<std::string, int> lines;
  std::vector<std::string> at_fault;  ///< "factors.KEY", and others that need no second fault
};

/// Keys that cannot be checked while a factor is unknown.
const std::vector<std::string> keys_about_all_factors{"factors", "samples", "indices"};

constexpr std::size_t max_materials = 1000;

struct Entry {
  std::string key;
  const input::TomlNode* node;
};

/// Collects the factors. [factors."impactor.speed"] and [factors.impactor.speed] are equal: a table that
/// leads to a known key is opened, every other one is a factor.
void collect(const input::TomlNode& table, const std::string& prefix, const std::vector<std::string>& known,
             std::vector<Entry>& entries) {
  for (const input::TomlNode& child : table.children) {
    const std::string key = prefix + child.key;
    const auto on_the_way = [&](const std::string& text) { return text.starts_with(key + "."); };
    if (child.kind == input::TomlNode::Kind::table && std::ranges::any_of(known, on_the_way))
      collect(child, key + ".", known, entries);
    else
      entries.push_back({key, &child});
  }
}

/// The material of a name; absent after a fault.
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
  if (list->children.empty() || list->children.size() > max_materials) {
    table.fault("values", fmt::format("must hold 1 to {} materials", max_materials));
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

/// The factors that can vary.
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

/// Reads the factors and the materials of "pad.material" into a study, faulty factors as far as possible.
/// Without a base case parameters and supports are not checked.
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

/// Adds broken rules of the study with their lines, but not those of factors at fault.
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

std::uint64_t read_count(input::TableReader& table, const std::string& key, double lowest, double highest) {
  return static_cast<std::uint64_t>(table.whole_number(key, lowest, highest).value_or(lowest));
}

Sampling read_sampling(input::TableReader& table) {
  if (!table.has("sampling")) return Sampling::sobol;
  const std::string chosen = table.choice("sampling", {"monte-carlo", "latin-hypercube", "sobol"});
  return chosen == "monte-carlo"       ? Sampling::monte_carlo
         : chosen == "latin-hypercube" ? Sampling::latin_hypercube
                                       : Sampling::sobol;
}

std::vector<std::string> read_responses(input::TableReader& table) {
  if (!table.has("responses")) return default_responses();
  std::vector<std::string> names;
  const input::TomlNode* list = table.array("responses");
  if (!list) return default_responses();
  for (const input::TomlNode& entry : list->children) {
    if (entry.kind != input::TomlNode::Kind::text)
      table.faults().add(entry, table.full_key("responses") + entry.key,
                         "must be the name of a response in quotes");
    names.push_back(entry.text);
  }
  return names;
}

/// The base case; absent after a fault.
std::optional<input::CaseFile> read_base(input::TableReader& table, const input::Folders& folders) {
  const std::string name = table.text("case");
  if (name.empty()) return std::nullopt;
  return table.faults().take(input::read_case(folders.of_file / name, folders.materials));
}

std::size_t number_of_factor(const Study& study, const std::string& key) {
  return static_cast<std::size_t>(std::ranges::find(study.factors, key, &Factor::key) -
                                  study.factors.begin());
}

void read_correlation(input::TableReader& table, const FactorLines& lines, Study& study) {
  std::vector<std::size_t> factors;
  if (const input::TomlNode* between = table.array("between")) {
    std::vector<std::string> keys;
    for (const Factor& factor : study.factors) keys.push_back(factor.key);
    for (const input::TomlNode& name : between->children) {
      factors.push_back(number_of_factor(study, name.text));
      if (factors.back() == study.factors.size() &&
          !std::ranges::count(lines.at_fault, "factors." + name.text))
        table.faults().add(name, table.full_key("between") + name.key,
                           "is not one of the factors" + input::did_you_mean(name.text, keys));
    }
    if (factors.size() != 2)
      table.fault("between", "must name two factors, such as [\"impactor.speed\", \"pad.thickness\"]");
  }
  const double value = table.number("value");
  table.refuse_others();
  const bool known = factors.size() == 2 && std::ranges::max(factors) < study.factors.size();
  if (known && !std::isnan(value)) study.correlations.push_back({factors[0], factors[1], value});
}

void read_correlations(input::TableReader& table, const FactorLines& lines, Study& study) {
  if (!table.has("correlations")) return;
  if (const input::TomlNode* list = table.array("correlations"))
    table.each_table("correlations", *list,
                     [&](input::TableReader& entry) { read_correlation(entry, lines, study); });
}

void read_sampling_plan(input::TableReader& table, Study& study) {
  const bool sampled = std::ranges::any_of(study.factors, &Factor::is_sampled);
  if (sampled || table.has("samples")) study.samples = read_count(table, "samples", 1, max_rows);
  study.sampling = read_sampling(table);
  if (table.has("seed")) study.seed = read_count(table, "seed", 0, input::largest_whole_number);
  study.indices = table.flag("indices");
}

}  // namespace

input::Reading<Study> read_study(const std::filesystem::path& file, const std::filesystem::path& materials) {
  const input::Reading<input::TomlFile> toml = input::read_toml(file);
  if (!toml) return toml.faults();
  input::FaultList faults(*toml);
  input::TableReader top(toml->root, "", faults);
  const input::Folders folders{file.parent_path(), materials};
  Study study;
  study.text = toml->text;
  study.title = top.text("title", input::Presence::optional);
  const auto base = read_base(top, folders);
  if (base) {
    study.base = base->impact;
    study.options = base->options;
  }
  study.options.tolerance = top.has("tolerance") ? top.number("tolerance") : default_tolerance;
  const FactorLines lines = read_factors(top, base.has_value(), folders, study);
  read_sampling_plan(top, study);
  read_correlations(top, lines, study);
  study.responses = read_responses(top);
  top.refuse_others();
  if (base) add_violations(violations(study), toml->root, lines, faults);
  return faults.reading(std::move(study));
}

}  // namespace dashpad::study
