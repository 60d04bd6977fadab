#include "dashpad/study/study_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "dashpad/study/responses.hpp"
#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "input/table_reader.hpp"
#include "study/factor_table.hpp"

namespace dashpad::study {
namespace {

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

/// Absent after a fault.
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
                           "is none of the factors" + input::did_you_mean(name.text, keys));
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
  if (sampled || table.has("samples")) study.samples = read_count(table, "samples", 1, most_rows);
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
