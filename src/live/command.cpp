#include "live/command.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/margin.hpp"
#include "input/spelling.hpp"
#include "live/exit_code.hpp"
#include "live/request.hpp"
#include "live/shown.hpp"
#include "live/written.hpp"

namespace dashpad::live {

namespace {

Json assessed(const Json& request, const Asked& asked, const Solution& solution) {
  injury::Assessment assessment = injury::assess(*asked.standard, asked.impact, solution);
  std::vector<injury::OtherChoice> others;
  if (is_set(request, "others")) others = other_choices(request, asked, assessment);
  const output::AssessmentReport report{*asked.standard, asked.given.impact, asked.impact, solution,
                                        assessment,      std::move(others),  asked.name};
  const auto document = [&](output::Pictures pictures) {
    return output::assessment_document(report, units_of(request), pictures);
  };
  const auto json = [&] { return output::assessment_json(report); };
  return {{"code", exit_code(assessment.verdict, solution.summary)},
          {"written", written(request, {.document = document, .json = json})}};
}

Json reported(const Json& request, const Asked& asked, const std::vector<Blow>& blows) {
  const UnitSystem& units = units_of(request);
  const Solution& solution = blows.back().solution;
  const auto injury = injury::whole_pulse_figures(solution);
  output::ImpactReport report{asked.impact, asked.given.options, solution, injury};
  if (asked.impact.blows) report.blows = output::blow_results(blows);
  const auto document = [&](output::Pictures pictures) {
    return output::impact_document(report, units, pictures);
  };
  const auto json = [&] { return output::result_json(asked.impact, solution.summary, injury, report.blows); };
  const auto page = [&] {
    report.snapshots = contact_snapshots(blows.back().impact, solution.history);
    return output::impact_page(report, units);
  };
  ExitCode code = exit_done;
  for (const Blow& blow : blows) code = std::max(code, exit_code(blow.solution.summary));
  return {{"code", code}, {"written", written(request, {.document = document, .json = json, .page = page})}};
}

Json write_solution(const Json& request, const Folders& folders) {
  const auto asked = read_asked(request, folders);
  if (!asked) return faults_json(asked.faults());
  const std::vector<Blow> blows = solved_blows(request, *asked, asked->given.options);
  return asked->standard ? assessed(request, *asked, blows.back().solution)
                         : reported(request, *asked, blows);
}

Json write_turns(const Json& request, const Folders& folders) {
  const auto question = read_question(request, folders);
  if (!question) return faults_json(question.faults());
  const margin::Answer found = margin::solve_for(*question);
  const std::string name = request.contains("file") ? text_of(request, "file") : name_of_case;
  const auto document = [&](output::Pictures pictures) {
    return output::margin_document(found, name, units_of(request), pictures);
  };
  const auto json = [&] { return output::margin_json(found); };
  return {{"code", exit_code(found)}, {"written", written(request, {.document = document, .json = json})}};
}

}  // namespace

std::string command_answer(std::string_view request, const Folders& folders) {
  return answered(request, [&](const Json& asked) {
    const std::string what = text_of(asked, "do");
    const Folders chosen = folders_of(asked, folders);
    return what == "solve"       ? write_solution(asked, chosen)
           : what == "solve-for" ? write_turns(asked, chosen)
           : what == "check"     ? check_case(asked, chosen)
           : what == "materials" ? show_materials(asked, chosen)
           : what == "standards" ? show_standards(asked, chosen)
           : what == "list"      ? list_all(chosen)
           : what == "spell"
               ? Json{{"text", input::meant_or_listed(text_of(asked, "word"), texts_of(asked, "words"))}}
               : fault_json("do", "must be solve, solve-for, check, materials, standards, list or spell");
  });
}

}  // namespace dashpad::live
