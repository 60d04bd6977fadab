#include "output/page/data.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "dashpad/injury/figures.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/version.hpp"
#include "output/blow_rows.hpp"
#include "output/page/columns.hpp"
#include "output/result_rows.hpp"
#include "output/text/case_toml.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using Json = nlohmann::ordered_json;

/// SI units of what the page plots; it converts with the factors given here and knows no others.
constexpr const char* plotted_units[] = {"m", "s", "m/s", "N", "Pa", "J"};

std::string title_of_system(const UnitSystem& units) {
  if (units.name == "si") return "SI";
  if (units.name == "us") return "US";
  return units.name == "engineering-metric" ? "Engineering metric" : units.name;
}

Json rows_json(const std::vector<ResultRow>& rows) {
  Json all = Json::array();
  for (const ResultRow& of : rows)
    all.push_back({{"label", of.label},
                   {"value", of.value},
                   {"unit", of.unit},
                   {"error", of.error ? shown_error(*of.error) : ""},
                   {"remark", of.remark}});
  return all;
}

Json injury_marks(const injury::InjuryFigures& of) {
  const auto mark = [](double value, double begin, double end) {
    return Json{{"value", rounded(value)}, {"begin", rounded(begin)}, {"end", rounded(end)}};
  };
  return {{"hic15", mark(of.hic15.value, of.hic15.begin, of.hic15.end)},
          {"hic36", mark(of.hic36.value, of.hic36.begin, of.hic36.end)},
          {"clip_3ms", mark(of.clip_3ms.level / standard_gravity, of.clip_3ms.begin, of.clip_3ms.end)}};
}

Json blows_json(const ImpactCase& impact, const std::vector<BlowResult>& blows, const UnitSystem& units) {
  if (blows.empty()) return nullptr;
  const Table table = blow_table(impact, blows, units, Detail::main);
  return {{"words", growth_text(impact, blows)},
          {"columns", table.columns},
          {"rows", table.rows},
          {"reservations", reservations(blows)}};
}

/// All that depends on the units: the factors, and texts with figures in them.
Json system(const UnitSystem& units, const ImpactCase& impact, const Solution& solution,
            const std::optional<injury::InjuryFigures>& injury, const std::vector<BlowResult>& blows) {
  Json factors = Json::object();
  for (const char* unit : plotted_units)
    factors[unit] = {{"unit", shown_unit(unit_for(units, unit))}, {"factor", value_in(units, 1, unit)}};
  ImpactCase untitled = impact;
  untitled.title.clear();
  return {{"name", units.name},
          {"title", title_of_system(units)},
          {"factors", factors},
          {"words", case_text(untitled, units)},
          {"warnings", warnings(solution.summary, units)},
          {"blows", blows_json(impact, blows, units)},
          {"figures", rows_json(summary_rows(impact, solution.summary, units, Detail::all))},
          {"injury", injury ? rows_json(pulse_rows(*injury, units, Detail::all)) : Json::array()}};
}

/// The names of what the page plots.
Json titles() {
  Json all = Json::object();
  for (const char* key :
       {"time", "force", "acceleration", "deceleration", "motion", "penetration", "support_deflection",
        "kinetic_energy", "support_energy", "pad_energy", "total_energy", "hic15", "hic36", "clip_3ms"})
    all[key] = result_quantity(key).title;
  return all;
}

}  // namespace

std::string page_data(const ImpactCase& impact, const Options& options, const Solution& solution,
                      const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots,
                      const std::vector<BlowResult>& blows) {
  const std::optional<injury::InjuryFigures> injury = injury::whole_pulse_figures(solution);
  Json systems = Json::array();
  for (const UnitSystem& units : unit_systems())
    systems.push_back(system(units, impact, solution, injury, blows));
  Json data;
  data["title"] = one_line(impact.title);
  data["shown"] = shown.name;
  data["status"] = to_string(solution.summary.status);
  data["outcome"] = outcome(solution.summary);
  data["numbers"] = numbers_text(solution.summary);
  data["energy_residual_fraction"] =
      rounded(std::abs(solution.summary.energy.residual / solution.summary.energy.impact));
  data["program"] = {{"version", version()}, {"commit", build_facts().git_commit}};
  data["case"] = case_toml(impact, options);
  data["titles"] = titles();
  data["systems"] = systems;
  data["injury"] = injury ? injury_marks(*injury) : Json(nullptr);
  data["history"] = page_history(impact, solution.history);
  data["snapshots"] = page_snapshots(snapshots);
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  replace_all(text, "<", "\\u003c");
  return text;
}

}  // namespace dashpad::output
