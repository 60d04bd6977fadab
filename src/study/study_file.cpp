#include "dashpad/study/study_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "input/case_rows.hpp"
#include "input/spelling.hpp"
#include "study/factor_spread.hpp"
#include "study/foam_factors.hpp"
#include "study/study_standards.hpp"

namespace dashpad::study {

namespace {

constexpr double default_tolerance = 1e-3;

/// A table of rows or of draws in its file.
struct TableFile {
  std::string file;
  int header_line = 0;
  std::vector<int> lines;         ///< of its rows
  std::vector<std::string> keys;  ///< of its columns
};

/// The lines of the factors in the file.
struct FactorLines {
  std::map<std::string, int> lines;
  std::map<std::string, TableFile> tables;  ///< by "rows" and "samples_from"
  std::vector<std::string> at_fault;        ///< "factors.KEY", and others that need no second fault
};

/// Keys that cannot be checked while a factor is unknown.
const std::vector<std::string> keys_about_all_factors{"factors", "samples", "indices"};

constexpr std::size_t max_materials = 1000;

constexpr const char* foam_uncertainty = "foam_uncertainty";

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

/// The material of a card, or of a .toml file. A fault of the name itself has no file.
input::Reading<Material> material_called(const std::string& name, const input::Folders& folders) {
  if (name.ends_with(".toml")) return input::read_material(folders.of_file / name);
  auto cards = input::list_materials(folders.materials);
  if (!cards) return cards.faults();
  for (const auto& card : *cards)
    if (card.stem() == name) return input::read_material(card);
  return std::vector{input::Fault{
      .file = "", .key = "", .value = "", .rule = input::no_such("card", name, folders.materials, *cards)}};
}

/// The material that an entry names; absent after a fault.
std::optional<Material> read_named(const input::TomlNode& entry, const std::string& key,
                                   const input::Folders& folders, input::FaultList& faults) {
  if (entry.kind != input::TomlNode::Kind::text || entry.text.empty()) {
    faults.add(entry, key, "must be the name of a card or a .toml file in quotes");
    return std::nullopt;
  }
  input::Reading<Material> material = material_called(entry.text, folders);
  if (material || !material.faults().front().file.empty()) return faults.take(std::move(material));
  faults.add(entry, key, material.faults().front().rule);
  return std::nullopt;
}

/// A material that cannot be read keeps its place as the base case's.
Levels read_materials(input::TableReader& table, const input::Folders& folders, Study& study) {
  Levels levels;
  const input::TomlNode* list = table.array("values");
  if (!list) return levels;
  if (list->children.empty() || list->children.size() > max_materials) {
    table.fault("values", fmt::format("must have between 1 and {} materials", max_materials));
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
    if (!on_trust) faults.add(*node, path, rule_for_unknown(key, study.base, known.keys));
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

/// The materials that a column of a table names, each once, in Study::materials, and their places there.
/// Empty after a fault, which has the line of the first row that names it.
std::vector<double> materials_named(const input::RowColumn& column, const TableFile& table,
                                    const input::Folders& folders, input::FaultList& faults, Study& study) {
  std::map<std::string, double> places;
  std::vector<double> values;
  const std::size_t before = faults.size();
  for (std::size_t row = 0; row < column.texts.size(); ++row) {
    const std::string& name = column.texts[row];
    const auto [place, is_new] = places.try_emplace(name, static_cast<double>(study.materials.size()));
    if (is_new) {
      input::Reading<Material> material = material_called(name, folders);
      const auto same = [&](const Material& each) { return material && each.name == material->name; };
      const auto known = std::ranges::find_if(study.materials, same);
      if (!material)
        for (input::Fault fault : material.faults()) {
          const bool is_of_card = !fault.file.empty();  // else it is of the name
          if (!is_of_card) fault = {table.file, table.lines[row], column.key, name, fault.rule};
          faults.add({std::move(fault)});
        }
      else if (known != study.materials.end())
        place->second = static_cast<double>(known - study.materials.begin());
      else
        study.materials.push_back(*std::move(material));
    }
    values.push_back(place->second);
  }
  return faults.size() == before ? values : std::vector<double>{};
}

/// Reads the table of rows or of draws, a CSV file, at `key`: a factor a column. False after a fault.
bool read_table(input::TableReader& top, const std::string& key, const std::vector<FactorKey>& keys,
                const input::Folders& folders, Study& study, FactorLines& lines) {
  if (!top.has(key)) return true;
  const auto file = top.file(key, folders.of_file);
  if (!file) return false;
  std::vector<input::RowKey> row_keys;
  for (const FactorKey& each : keys)
    if (key == "rows" || !each.unit.empty()) row_keys.push_back({.key = each.key, .unit = each.unit});
  const auto unknown = [&](const std::string& name) {
    return name == "pad.material" ? "cannot be drawn: name the materials in a table of rows"
                                  : rule_for_unknown(name, study.base, keys);
  };
  const auto rows = top.faults().take(input::read_case_rows(*file, row_keys, unknown));
  if (!rows) return false;
  TableFile& table = lines.tables[key] = {file->string(), rows->header_line, rows->lines, {}};
  const std::size_t before = top.faults().size();
  for (const input::RowColumn& column : rows->columns) {
    std::vector<double> values =
        column.unit.empty() ? materials_named(column, table, folders, top.faults(), study) : column.values;
    table.keys.push_back(column.key);
    if (values.empty()) continue;
    Factor factor{.key = column.key, .unit = column.unit, .spread = ByRow{values}};
    if (key == "samples_from") factor.spread = ByDraw{std::move(values)};
    study.factors.push_back(std::move(factor));
  }
  if (key == "rows")
    for (const input::RowColumn& label : rows->labels) study.labels.push_back({label.key, label.texts});
  return top.faults().size() == before;
}

/// Reads the tables, the factors and the materials of "pad.material" into a study, faulty factors as far as
/// possible. Without a base case parameters and supports are not checked.
FactorLines read_factors(input::TableReader& top, bool has_base, const input::Folders& folders,
                         Study& study) {
  FactorLines lines;
  const std::vector<FactorKey> keys = factor_keys(study);
  for (const char* const key : {"rows", "samples_from"})
    if (has_base ? !read_table(top, key, keys, folders, study, lines) : top.has(key))
      lines.at_fault.emplace_back(key);
  const bool has_others = top.has("rows") || top.has("samples_from") || top.has(foam_uncertainty);
  const auto table = top.table("factors", has_others ? input::Presence::optional : input::Presence::required);
  if (!table) {
    if (has_others && lines.at_fault.empty()) return lines;
    lines.at_fault = keys_about_all_factors;
    return lines;
  }
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

/// The fault of a broken rule that is about a table: "rows[3].impactor.speed", "factors.impactor.speed".
std::optional<input::Fault> fault_in_table(const Violation& violation, const FactorLines& lines) {
  for (const auto& [name, table] : lines.tables) {
    const std::string& key = violation.key;
    if (key.starts_with(name + "[")) {
      const std::size_t end = key.find(']');
      const std::size_t row = std::stoul(key.substr(name.size() + 1, end - name.size() - 1));
      return input::Fault{table.file, table.lines.at(row - 1), key.substr(end + 2),
                          fmt::format("{:.6g}", violation.value), violation.rule};
    }
    if (key.starts_with("factors.") && !lines.lines.contains(key) &&
        std::ranges::count(table.keys, key.substr(8)))
      return input::Fault{table.file, table.header_line, key.substr(8), "", violation.rule};
  }
  return std::nullopt;
}

/// Adds broken rules of the study with their lines, but not those of factors at fault.
void add_violations(const std::vector<Violation>& broken, const input::TomlNode& root,
                    const FactorLines& lines, input::FaultList& faults) {
  for (const Violation& violation : broken) {
    if (std::ranges::count(lines.at_fault, violation.key)) continue;
    if (std::optional<input::Fault> fault = fault_in_table(violation, lines)) {
      faults.add({*std::move(fault)});
      continue;
    }
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
                         "must be the name of a response, in quotes");
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

/// Adds what the cards leave uncertain to the factors, if the file asks for it.
void read_foam_uncertainty(input::TableReader& top, FactorLines& lines, Study& study) {
  const std::size_t before = top.faults().size();
  const bool is_wanted = top.flag(foam_uncertainty);
  if (top.faults().size() > before)
    lines.at_fault.insert(lines.at_fault.end(), keys_about_all_factors.begin(), keys_about_all_factors.end());
  if (!is_wanted || !lines.at_fault.empty()) return;
  if (foam_factors(study).empty())
    top.fault(foam_uncertainty, "the card of the pad leaves nothing uncertain that could be drawn");
  draw_foam_uncertainty(study);
}

void read_sampling_plan(input::TableReader& table, Study& study) {
  const bool sampled = std::ranges::any_of(study.factors, &Factor::is_sampled);
  if (sampled || table.has("samples")) study.samples = read_count(table, "samples", 1, max_rows);
  study.sampling = read_sampling(table);
  if (table.has("seed")) study.seed = read_count(table, "seed", 0, input::largest_whole_number);
  study.indices = table.flag("indices");
}

}  // namespace

input::Reading<Study> read_study(const std::filesystem::path& file, const std::filesystem::path& materials,
                                 const std::filesystem::path& standards) {
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
  study.responses = read_responses(top);
  read_standards(top, folders, standards, study);
  study.options.tolerance = top.has("tolerance") ? top.number("tolerance") : default_tolerance;
  FactorLines lines = read_factors(top, base.has_value(), folders, study);
  if (base) read_foam_uncertainty(top, lines, study);
  read_sampling_plan(top, study);
  read_correlations(top, lines, study);
  top.refuse_others();
  if (base) add_violations(violations(study), toml->root, lines, faults);
  return faults.reading(std::move(study));
}

}  // namespace dashpad::study
