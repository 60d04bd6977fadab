#include "live/answer.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/margin.hpp"
#include "dashpad/study/study.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "input/toml_tree.hpp"
#include "json/json_values.hpp"
#include "live/case_tables.hpp"
#include "live/request.hpp"
#include "live/shown.hpp"
#include "live/written.hpp"
#include "output/page/html.hpp"
#include "output/page/html_elements.hpp"

namespace dashpad::live {

namespace {

const char* name_of(output::Tone tone) { return output::class_of_tone(tone); }

/// Of the whole page, or of its lead alone, which takes a third of the time.
void add_page(const Json& request, const UnitSystem& units, output::Document document, Json& answer) {
  if (!is_set(request, "whole")) document.sections.clear();
  answer["title"] = document.lead->answer;
  answer["tone"] = name_of(document.lead->tone);
  answer["html"] = output::html_of({{&units, std::move(document)}}).body;
}

Json numbers_of(const ImpactCase& impact) {
  Json numbers{
      {"mass", impact.impactor.mass}, {"speed", impact.impactor.speed}, {"thickness", impact.pad.thickness}};
  Json layers = Json::array();
  for (const PadLayer& layer : impact.pad.layers) layers.push_back(layer.thickness);
  numbers["layers"] = layers;
  return numbers;
}

/// As the command ends with it.
int code_of(const Summary& summary) {
  constexpr int done = 0, not_trusted = 3;
  return summary.trustworthy() || bottomed_on_rigid_support(summary) ? done : not_trusted;
}
int code_of(injury::Verdict verdict, const Summary& summary) {
  constexpr int not_trusted = 3, not_passed = 4;
  if (verdict == injury::Verdict::pass) return code_of(summary);
  return verdict == injury::Verdict::fail ? not_passed : not_trusted;
}
int code_of(const margin::Answer& answer) {
  constexpr int done = 0, not_trusted = 3, not_passed = 4;
  const auto any = [&](margin::Zone zone) {
    return std::ranges::find(answer.stretches, zone, &margin::Stretch::zone) != answer.stretches.end();
  };
  if (!answer.is_complete || answer.doubtful > 0) return not_trusted;
  if (any(margin::Zone::pass)) return done;
  return any(margin::Zone::undecided) || any(margin::Zone::unknown) ? not_trusted : not_passed;
}

/// What the other choices of nose and speed would have changed.
std::vector<injury::OtherChoice> other_choices(const Json& request, const Asked& asked,
                                               injury::Assessment& assessment) {
  Options coarse = asked.given.options;
  coarse.tolerance = 1e-3;
  const auto judged = [&](const injury::Standard& standard, const ImpactCase& impact) {
    Solution solution = solve(impact, coarse);
    if (is_set(request, "intervals"))
      uncertainty::add_intervals(impact, coarse, solution, injury::dwell_levels(standard));
    return injury::assess(standard, impact, solution);
  };
  std::vector<injury::OtherChoice> others =
      injury::turning_choices(*asked.own, asked.given.impact, asked.kept, assessment.verdict, judged);
  for (const injury::OtherChoice& choice : others)
    assessment.reservations.push_back(
        output::other_choice(choice, *asked.own, asked.given.impact, units_of(request)));
  return others;
}

Json assess_solution(const Json& request, const Asked& asked, const Solution& solution) {
  const UnitSystem& units = units_of(request);
  injury::Assessment assessment = injury::assess(*asked.standard, asked.impact, solution);
  std::vector<injury::OtherChoice> others;
  if (is_set(request, "others")) others = other_choices(request, asked, assessment);
  const output::AssessmentReport report{*asked.standard, asked.given.impact, asked.impact, solution,
                                        assessment,      std::move(others),  asked.name};
  const auto json = [&] { return output::assessment_json(report); };
  const auto document = [&](output::Pictures pictures) {
    return output::assessment_document(report, units, pictures);
  };
  Json answer{{"code", code_of(assessment.verdict, solution.summary)}};
  if (request.contains("write")) {
    answer["written"] = written(request, {.document = document, .json = json});
  } else {
    answer["result"] = Json::parse(json());
    add_page(request, units, document(output::Pictures::drawn), answer);
  }
  return answer;
}

Json report_blows(const Json& request, const Asked& asked, const Options& options,
                  const std::vector<Blow>& blows) {
  const UnitSystem& units = units_of(request);
  const Solution& solution = blows.back().solution;
  const auto injury = injury::whole_pulse_figures(solution);
  output::ImpactReport report{asked.impact, options, solution, injury};
  if (asked.impact.blows) report.blows = output::blow_results(blows);
  const auto look = [&] { report.snapshots = contact_snapshots(blows.back().impact, solution.history); };
  const auto json = [&] { return output::result_json(asked.impact, solution.summary, injury, report.blows); };
  const auto document = [&](output::Pictures pictures) {
    return output::impact_document(report, units, pictures);
  };
  int code = 0;
  for (const Blow& blow : blows) code = std::max(code, code_of(blow.solution.summary));
  Json answer{{"code", code}};
  if (request.contains("write")) {
    const auto page = [&] {
      look();
      return output::impact_page(report, units);
    };
    answer["written"] = written(request, {.document = document, .json = json, .page = page});
  } else {
    answer["result"] = Json::parse(json());
    if (is_set(request, "whole")) look();
    add_page(request, units, document(output::Pictures::drawn), answer);
  }
  return answer;
}

Json solve_case(const Json& request, const Folders& folders) {
  const auto asked = read_asked(request, folders);
  if (!asked) return faults_json(asked.faults());
  Options options = asked->given.options;
  constexpr double quick = 1e-3;
  if (is_set(request, "quick")) options.tolerance = std::max(options.tolerance, quick);
  const ImpactCase& impact = asked->impact;
  const auto& standard = asked->standard;

  std::vector<Blow> blows =
      standard ? std::vector{Blow{impact, solve(impact, options)}} : solve_blows(impact, options);
  Solution& solution = blows.back().solution;
  if (is_set(request, "intervals"))
    uncertainty::add_intervals(impact, options, solution,
                               standard ? injury::dwell_levels(*standard) : std::vector<double>{});
  Json answer =
      standard ? assess_solution(request, *asked, solution) : report_blows(request, *asked, options, blows);
  answer["numbers"] = numbers_of(impact);
  if (request.contains("case")) answer["toml"] = toml_of(request["case"]);
  return answer;
}

Json solve_for(const Json& request, const Folders& folders) {
  std::vector<input::Fault> faults;
  const auto standard = read_standard(request, folders);
  if (!standard) faults = standard.faults();
  const auto given = read_case(request, folders);
  if (!given) add(given.faults(), faults);
  if (!faults.empty()) return faults_json(faults);
  if (!*standard) return fault_json("standard", "choose a standard, whose limits the pad is to keep");
  margin::Question question{.impacts = {}, .key = text_of(request, "key"), .unit = {}};
  question.options = given->options;
  if (const auto tolerance = number_of(request, "tolerance")) question.options.tolerance = *tolerance;
  if (request.contains("intervals")) question.intervals = is_set(request, "intervals");
  const injury::Standard judged = injury::without_value_of(**standard, decided_by(question.key));
  question.impacts.push_back({.impact = injury::with_impactor_of(judged, given->impact), .standard = judged});
  const auto refused = [&](const std::string& rule) {
    return faults_json({{.file = question.key, .key = "", .value = "", .rule = rule}});
  };
  const std::vector<study::FactorKey> known = study::factor_keys(given->impact);
  const auto key = std::ranges::find(known, question.key, &study::FactorKey::key);
  if (key == known.end()) return refused(study::rule_for_unknown(question.key, given->impact, known));
  if (key->unit.empty()) return refused("is no number; compare materials in a study (docs/studies.md)");
  question.unit = key->unit;
  if (!margin::choose_range(question)) return refused("the case has no value above 0 to search about");
  for (const Violation& violation : margin::violations(question))
    faults.push_back({.file = violation.key, .key = "", .value = "", .rule = violation.rule});
  if (!faults.empty()) return faults_json(faults);
  const margin::Answer found = margin::solve_for(question);
  const UnitSystem& units = units_of(request);
  const std::string name = request.contains("file") ? text_of(request, "file") : name_of_case;
  Json answer{{"title", output::margin_answer(found, units)}, {"code", code_of(found)}};
  const auto json = [&] { return output::margin_json(found); };
  const auto document = [&](output::Pictures pictures) {
    return output::margin_document(found, name, units, pictures);
  };
  if (request.contains("write"))
    answer["written"] = written(request, {.document = document, .json = json});
  else
    answer["result"] = Json::parse(json());
  return answer;
}

Json read_file(const Json& request) {
  const auto toml = input::read_toml_text(name_of_case, text_of(request, "text"));
  if (!toml) return faults_json(toml.faults());
  return {{"case", tables_of(toml->root)}};
}

/// Names and titles, in the order of the names.
Json list_all(const Folders& folders) {
  Json list{{"foams", Json::array()}, {"standards", Json::array()}};
  if (const auto cards = input::list_materials(folders.materials))
    for (const std::filesystem::path& card : *cards)
      if (const auto material = input::read_material(card))
        list["foams"].push_back({{"name", material->name}, {"title", material->title}});
  if (const auto files = input::list_standards(folders.standards))
    for (const std::filesystem::path& file : *files)
      if (const auto standard = input::read_standard(file)) {
        Json variants = Json::array();
        for (const injury::StandardVariant& variant : standard->variants) variants.push_back(variant.name);
        list["standards"].push_back(
            {{"name", standard->name}, {"title", standard->title}, {"variants", variants}});
      }
  return list;
}

}  // namespace

std::string answer(std::string_view request, const Folders& folders) {
  constexpr std::size_t max_request = std::size_t{1} << 20;
  if (request.size() > max_request) return fault_json("", "is larger than 1 MiB").dump();
  const Json asked = Json::parse(request, nullptr, false);
  if (!asked.is_object()) return fault_json("", "is not a request").dump();
  const std::string what = text_of(asked, "do");
  const Folders chosen = folders_of(asked, folders);
  const Json answer =
      what == "solve"       ? solve_case(asked, chosen)
      : what == "solve-for" ? solve_for(asked, chosen)
      : what == "check"     ? check_case(asked, chosen)
      : what == "materials" ? show_materials(asked, chosen)
      : what == "standards" ? show_standards(asked, chosen)
      : what == "read"      ? read_file(asked)
      : what == "list"
          ? list_all(chosen)
          : fault_json("do", "must be solve, solve-for, check, materials, standards, read or list");
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace dashpad::live
