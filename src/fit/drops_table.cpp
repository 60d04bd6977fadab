// Drops of one case as rows of a table.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/study/study.hpp"
#include "fit/fit_tables.hpp"
#include "input/case_rows.hpp"
#include "input/spelling.hpp"

namespace dashpad::fit {
namespace {

/// Numbers of the case, then measured figures, of which some drops may lack one.
std::vector<input::RowKey> keys_of_drops(const ImpactCase& impact) {
  std::vector<input::RowKey> keys;
  for (const CaseQuantity& quantity : quantities_of(impact))
    keys.push_back({.key = quantity.key, .unit = quantity.unit});
  for (const ImpactFigureName& name : impact_figure_names())
    keys.push_back({.key = name.key, .unit = name.quantity->si_unit, .may_be_empty = true});
  return keys;
}

const ImpactFigureName* figure_called(const std::string& key) {
  const auto& names = impact_figure_names();
  const auto found =
      std::ranges::find_if(names, [&](const ImpactFigureName& name) { return key == name.key; });
  return found == names.end() ? nullptr : &*found;
}

/// Adds a fault for each label that may be meant as a figure; false if there is none.
bool add_misspelt_figures(const input::CaseRows& rows, const std::string& file, input::FaultList& faults) {
  std::vector<std::string> names;
  for (const ImpactFigureName& name : impact_figure_names()) names.emplace_back(name.key);
  const std::size_t before = faults.size();
  for (const input::RowColumn& label : rows.labels) {
    std::string word = label.key.substr(0, label.key.find_first_of("[("));
    word = word.substr(0, word.find_last_not_of(' ') + 1);
    std::ranges::replace(word, ' ', '_');
    if (const std::string meant = input::did_you_mean(word, names); !meant.empty() && word.size() > 2)
      faults.add({input::Fault{file, rows.header_line, label.key, "", "is not a measured figure" + meant}});
  }
  return faults.size() > before;
}

/// A column whose numbers would not be used: `set` gives them for all drops, the fit seeks them, or another
/// column gives them in another way.
void refuse_overruled(input::TableReader& table, const input::CaseRows& rows, const std::string& file,
                      const Fit& fit) {
  std::vector<std::string> settings;
  if (const input::TomlNode* const set = table.node().child("set")) settings = settings_in(*set);
  for (const input::RowColumn& column : rows.columns) {
    const auto refuse = [&](const char* rule) {
      table.faults().add({input::Fault{file, rows.header_line, column.key, "", rule}});
    };
    const auto is_own = [&](const std::string& key) { return decided_by(key) == decided_by(column.key); };
    if (std::ranges::any_of(settings, [&](const auto& set) { return is_own(set.substr(0, set.find('='))); }))
      refuse("is also given by set, for all drops: leave one of them out");
    if (std::ranges::any_of(fit.unknowns, is_own, &Unknown::key))
      refuse("is also decided by an unknown of the fit: leave one of them out");
    for (const input::RowColumn& other : rows.columns)
      if (&other < &column && is_own(other.key))
        refuse("is also given by another column: leave one of them out");
  }
}

}  // namespace

std::vector<ImpactMeasurement> read_drops(input::TableReader& table, const input::Folders& folders,
                                          const ImpactMeasurement& stem, const Fit& fit,
                                          std::vector<input::InputFile>& files) {
  std::vector<ImpactMeasurement> drops;
  const auto file = table.file("rows", folders.of_file);
  if (file) files.push_back({"the table of drops", *file});
  const double deviation = table.quantity("deviation", "1");
  if (stem.pulse || !stem.figures.empty())
    table.fault("rows", "contains the measurements; the entry itself must have none");
  const std::vector<input::RowKey> keys = keys_of_drops(stem.impact);
  const auto unknown = [&](const std::string& key) -> std::string {
    if (key == "pad.material") return "cannot differ among drops: a fit has one foam";
    return study::rule_for_unknown(key, stem.impact, study::factor_keys(stem.impact));
  };
  const auto rows = file ? table.faults().take(input::read_case_rows(*file, keys, unknown)) : std::nullopt;
  if (!rows) return drops;
  if (add_misspelt_figures(*rows, file->string(), table.faults())) return drops;
  refuse_overruled(table, *rows, file->string(), fit);
  const CaseQuantities quantities = quantities_of(stem.impact);
  for (std::size_t i = 0; i < rows->lines.size(); ++i) {
    ImpactMeasurement drop = stem;
    drop.file += fmt::format(", line {} of {}", rows->lines[i], file->filename().string());
    const auto fault = [&](const std::string& key, double value, std::string rule) {
      table.faults().add(
          {input::Fault{file->string(), rows->lines[i], key, fmt::format("{:g}", value), std::move(rule)}});
    };
    for (const input::RowColumn& column : rows->columns) {
      const double value = column.values[i];
      if (const ImpactFigureName* const name = figure_called(column.key)) {
        if (value <= 0) fault(column.key, value, "must be more than 0: all figures are magnitudes");
        if (std::isfinite(value)) drop.figures.push_back({name->figure, value, deviation * value});
      } else {
        quantities.find(column.key)->set(drop.impact, value);
      }
    }
    if (drop.figures.empty())
      table.faults().add({input::Fault{file->string(), rows->lines[i], "", "", "has no measured figure"}});
    for (const Violation& broken : violations(drop.impact)) fault(broken.key, broken.value, broken.rule);
    drops.push_back(std::move(drop));
  }
  return drops;
}

}  // namespace dashpad::fit
