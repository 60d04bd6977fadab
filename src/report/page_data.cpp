#include "report/page_data.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "dashpad/injury/figures.hpp"
#include "dashpad/io/case_text.hpp"
#include "dashpad/version.hpp"
#include "io/summary_rows.hpp"
#include "io/text.hpp"
#include "report/case_toml.hpp"
#include "report/page_columns.hpp"

namespace dashpad {

namespace {

using Json = nlohmann::ordered_json;

/// SI units of what the page plots; it converts with the factors given here and knows no others.
constexpr const char* plotted_units[] = {"m", "s", "m/s", "N", "Pa", "J"};

std::string title_of(const UnitSystem& units) {
  if (units.name == "si") return "SI";
  if (units.name == "us") return "US";
  return units.name == "engineering-metric" ? "Engineering metric" : units.name;
}

Json row(const SummaryRow& of) {
  return {{"label", of.label},
          {"value", of.value},
          {"unit", of.unit},
          {"error", of.error},
          {"remark", of.remark}};
}

std::string window(double begin, double end, const UnitSystem& units) {
  return "from " + brief_quantity(begin, "s", units) + " to " + brief_quantity(end, "s", units);
}

Json injury_rows(const InjuryFigures& of, const UnitSystem& units) {
  const auto& errors = of.errors;
  const auto hic = [&](const char* label, const Hic& figure, double error) {
    return row(
        {label, significant(figure.value), "", shown_error(error), window(figure.begin, figure.end, units)});
  };
  Json rows = Json::array();
  rows.push_back(hic("HIC15", of.hic15, errors.hic15));
  rows.push_back(hic("HIC36", of.hic36, errors.hic36));
  rows.push_back(row({"3 ms level", significant(of.contiguous_3ms.level / standard_gravity), "g",
                      shown_error(errors.contiguous_3ms), "held without a break"}));
  rows.push_back(row(
      {"Severity index", significant(of.severity_index), "", shown_error(errors.severity_index), "Gadd"}));
  rows.push_back(row({"Velocity change", significant(value_in(units, std::abs(of.velocity_change), "m/s")),
                      shown_unit(unit_for(units, "m/s")), shown_error(errors.velocity_change), ""}));
  return rows;
}

Json injury_marks(const InjuryFigures& of) {
  const auto mark = [](double value, double begin, double end) {
    return Json{{"value", rounded(value)}, {"begin", rounded(begin)}, {"end", rounded(end)}};
  };
  return {{"hic15", mark(of.hic15.value, of.hic15.begin, of.hic15.end)},
          {"hic36", mark(of.hic36.value, of.hic36.begin, of.hic36.end)},
          {"clip",
           mark(of.contiguous_3ms.level / standard_gravity, of.contiguous_3ms.begin, of.contiguous_3ms.end)}};
}

/// All that depends on the units: the factors, and texts with figures in them.
Json system(const UnitSystem& units, const ImpactCase& impact, const Solution& solution,
            const std::optional<InjuryFigures>& injury) {
  Json factors = Json::object();
  for (const char* unit : plotted_units)
    factors[unit] = {{"unit", shown_unit(unit_for(units, unit))}, {"factor", value_in(units, 1, unit)}};
  Json figures = Json::array();
  for (const SummaryRow& figure : summary_rows(impact, solution.summary, units))
    figures.push_back(row(figure));
  ImpactCase untitled = impact;
  untitled.title.clear();
  return {{"name", units.name},
          {"title", title_of(units)},
          {"factors", factors},
          {"words", case_text(untitled, units)},
          {"warnings", warnings(solution.summary, units)},
          {"figures", figures},
          {"injury", injury ? injury_rows(*injury, units) : Json::array()}};
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::string page_data(const ImpactCase& impact, const Options& options, const Solution& solution,
                      const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots) {
  const std::optional<InjuryFigures> injury = whole_pulse_figures(solution);
  Json systems = Json::array();
  for (const UnitSystem& units : unit_systems()) systems.push_back(system(units, impact, solution, injury));
  Json data;
  data["title"] = one_line(impact.title);
  data["shown"] = shown.name;
  data["status"] = to_string(solution.summary.status);
  data["outcome"] = outcome(solution.summary);
  data["numbers"] = numbers_text(solution.summary);
  data["energy_residual"] =
      rounded(std::abs(solution.summary.energy.residual / solution.summary.energy.initial));
  data["program"] = {{"version", version()}, {"commit", build_facts().git_commit}};
  data["case"] = case_toml(impact, options);
  data["systems"] = systems;
  data["injury"] = injury ? injury_marks(*injury) : Json(nullptr);
  data["history"] = page_history(impact, solution.history);
  data["snapshots"] = page_snapshots(snapshots);
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  replace_all(text, "<", "\\u003c");
  return text;
}

}  // namespace dashpad
