#include "live/answer.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/margin.hpp"
#include "input/toml_tree.hpp"
#include "json/json_values.hpp"
#include "live/case_tables.hpp"
#include "live/measured.hpp"
#include "live/request.hpp"
#include "output/text/case_toml.hpp"

namespace dashpad::live {

namespace {

/// What a page has sliders for; "more" has the sizes of the nose and the numbers of the support.
Json numbers_of(const ImpactCase& impact) {
  Json numbers{
      {"mass", impact.impactor.mass}, {"speed", impact.impactor.speed}, {"thickness", impact.pad.thickness}};
  Json layers = Json::array();
  for (const PadLayer& layer : impact.pad.layers) layers.push_back(layer.thickness);
  numbers["layers"] = layers;
  numbers["more"] = Json::array();
  for (const CaseQuantity& quantity : quantities_of(impact)) {
    const std::string& key = quantity.key;
    const std::string decided = decided_by(key);
    const bool is_size = key.starts_with("impactor.") && decided != "impactor.mass" &&
                         decided != "impactor.speed" && key != "impactor.gravity";
    const double value = is_size || key.starts_with("support.") ? quantity.get(impact) : 0;
    if (value > 0 && key != "support.scale")
      numbers["more"].push_back({{"key", key}, {"unit", quantity.unit}, {"value", value}});
  }
  return numbers;
}

Json solve_case(const Json& request, const Folders& folders) {
  const auto asked = read_asked(request, folders);
  if (!asked) return faults_json(asked.faults());
  Options options = asked->given.options;
  constexpr double quick = 1e-3;
  const bool is_quick = is_set(request, "quick");
  if (is_quick) options.tolerance = std::max(options.tolerance, quick);
  const UnitSystem& units = units_of(request);
  const ImpactCase& impact = asked->impact;
  std::vector<Blow> blows = solved_blows(request, *asked, options);
  const Solution& solution = blows.back().solution;
  // A page that follows a slider has the lead alone, a tenth of the work.
  const bool is_whole = is_set(request, "whole");
  const output::Pictures pictures = is_whole ? output::Pictures::drawn : output::Pictures::of_lead;
  output::Document document;
  Json answer;
  if (asked->standard) {
    injury::Assessment assessment = injury::assess(*asked->standard, impact, solution);
    std::vector<injury::OtherChoice> others;
    if (is_set(request, "intervals")) others = other_choices(request, *asked, assessment);
    const output::AssessmentReport report{*asked->standard, asked->given.impact, impact,
                                          solution,         assessment,          std::move(others)};
    if (!is_quick) answer["result"] = Json::parse(output::assessment_json(report));
    document = output::assessment_document(report, units, pictures);
  } else {
    const auto injury = injury::whole_pulse_figures(solution);
    output::ImpactReport report{impact, options, solution, injury};
    if (impact.blows) report.blows = output::blow_results(blows);
    if (!is_quick)
      answer["result"] = Json::parse(output::result_json(impact, solution.summary, injury, report.blows));
    if (is_whole) report.snapshots = contact_snapshots(blows.back().impact, solution.history);
    document = output::impact_document(report, units, pictures);
  }
  if (!is_whole) document.sections.clear();
  add_page(answer, std::move(document), units);
  answer["numbers"] = numbers_of(impact);
  // A card of the reader's own is nowhere else, so that the case has its law.
  answer["toml"] = is_set(request, "whole_foam") || !request.contains("case")
                       ? output::case_toml(asked->given.impact, asked->given.options)
                       : toml_of(request["case"]);
  return answer;
}

Json solve_for(const Json& request, const Folders& folders) {
  const auto question = read_question(request, folders);
  if (!question) return faults_json(question.faults());
  const margin::Answer found = margin::solve_for(*question);
  return {{"result", Json::parse(output::margin_json(found))},
          {"title", output::margin_answer(found, units_of(request))}};
}

Json read_file(const Json& request) {
  const auto toml = input::read_toml_text(name_of_case, text_of(request, "text"));
  if (!toml) return faults_json(toml.faults());
  return {{"case", tables_of(toml->root)}};
}

}  // namespace

std::string answer(std::string_view request, const Folders& folders) {
  return answered(request, [&](const Json& asked) {
    const std::string what = text_of(asked, "do");
    return what == "solve"       ? solve_case(asked, folders)
           : what == "solve-for" ? solve_for(asked, folders)
           : what == "read"      ? read_file(asked)
           : what == "fit"       ? fit_tests(asked)
           : what == "pulse"     ? show_pulse(asked, folders)
           : what == "list"      ? list_all(folders)
                                 : fault_json("do", "must be solve, solve-for, read, fit, pulse or list");
  });
}

}  // namespace dashpad::live
