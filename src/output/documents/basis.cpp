#include "output/documents/basis.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "dashpad/output/text/case.hpp"
#include "dashpad/version.hpp"
#include "output/result_rows.hpp"
#include "output/text/capitals.hpp"
#include "output/text/foam_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

Table basis_table(const std::vector<Basis>& rows) {
  Table table{.columns = {"", "Value"}};
  for (const Basis& row : rows) table.rows.push_back({row.what, row.value});
  const auto add = [&](const char* title, std::string Basis::*part) {
    if (std::ranges::all_of(rows, [&](const Basis& row) { return (row.*part).empty(); })) return;
    table.columns.emplace_back(title);
    for (std::size_t i = 0; i < rows.size(); ++i) table.rows[i].push_back(rows[i].*part);
  };
  add("Source", &Basis::source);
  add("Remarks", &Basis::doubt);
  return table;
}

std::string doubts_about(const Material& material) {
  std::string doubts;
  for (const std::string& reservation : material.reservations)
    doubts += (doubts.empty() ? "" : " ") + one_line(reservation);
  return doubts;
}

std::string known_of(const Material& material, const UnitSystem& units) {
  std::string words;
  if (material.density) words = brief_quantity(*material.density, "kg/m3", units);
  if (const auto range = range_of(material))
    words += fmt::format(
        "{}{} up to a strain of {}, at a strain rate of {}{} per second", words.empty() ? "" : "; ",
        how_known(material), brief(range->highest_strain, 3), brief(range->lowest_rate, 3),
        range->highest_rate > range->lowest_rate ? " to " + brief(range->highest_rate, 3) : "");
  return words;
}

std::string source_of(const Material& material) {
  if (!material.source.empty()) return one_line(material.source);
  return material.name == foam_of_the_case ? "typed in the case; no source is given" : "not stated";
}

Basis foam_basis(const Material& material, const UnitSystem& units) {
  Basis basis{.what = "Foam", .value = material_words(material)};
  if (const std::string known = known_of(material, units); !known.empty())
    basis.value += (material.density ? ", " : "; ") + known;
  basis.source = source_of(material);
  basis.doubt = doubts_about(material);
  return basis;
}

std::vector<Basis> case_basis(const ImpactCase& impact, const UnitSystem& units) {
  const CaseWords words = case_words(impact, units);
  std::vector<Basis> rows{{"Impactor", fmt::format("{}, at {}", words.impactor, words.speed)},
                          {"Pad", words.pad}};
  std::set<std::string> names;
  const auto add = [&](const Material& material) {
    if (names.insert(material.name + material.title).second) rows.push_back(foam_basis(material, units));
  };
  if (impact.pad.layers.empty()) add(impact.pad.material);
  for (const PadLayer& layer : impact.pad.layers) add(layer.material);
  rows.push_back({"Support", words.support});
  if (!words.blows.empty()) rows.push_back({"Blows", words.blows});
  return rows;
}

std::vector<Basis> method_basis(const ImpactCase& impact, const Computed& computed) {
  std::vector<Basis> rows;
  for (const Use& use : method_of(impact, computed))
    rows.push_back({rows.empty() ? "Method" : "", capitalised(fmt::format("{}", fmt::join(use.what, ", "))),
                    source_of(use)});
  return rows;
}

Basis solver_basis(const Summary& summary) {
  return {.what = "Solution",
          .value = numbers_text(summary),
          .source = fmt::format("dashpad {}", version()),
          .doubt = fmt::format("energy residual {}",
                               percentage(std::abs(summary.energy.residual / summary.energy.impact)))};
}

std::vector<std::string> case_lines(const ImpactCase& impact, const UnitSystem& units) {
  ImpactCase untitled = impact;
  untitled.title.clear();
  std::vector<std::string> lines;
  const std::string text = case_text(untitled, units);
  for (std::size_t from = 0, end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
    lines.push_back(text.substr(from, end - from));
  return lines;
}

}  // namespace dashpad::output
