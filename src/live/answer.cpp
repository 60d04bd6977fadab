#include "live/answer.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

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
#include "dashpad/uncertainty/intervals.hpp"
#include "input/toml_tree.hpp"
#include "json/json_values.hpp"
#include "live/case_tables.hpp"
#include "output/page/html.hpp"
#include "output/page/html_elements.hpp"

namespace dashpad::live {

namespace {

/// What a live page shows of a case has no name of a file.
constexpr const char* name_of_case = "the case";

Json faults_json(const std::vector<input::Fault>& faults) {
  return {{"faults", array_of(faults, [](const input::Fault& fault) {
             return Json{{"line", fault.line},
                         {"key", fault.key},
                         {"value", fault.value},
                         {"rule", fault.rule},
                         {"text", with_excerpt(fault)}};
           })}};
}
Json fault_json(const std::string& key, const std::string& rule) {
  return faults_json({{.file = name_of_case, .key = key, .value = "", .rule = rule}});
}

std::string text_of(const Json& request, const char* key) {
  const auto found = request.find(key);
  return found != request.end() && found->is_string() ? found->get<std::string>() : "";
}
bool is_set(const Json& request, const char* key) {
  const auto found = request.find(key);
  return found != request.end() && found->is_boolean() && found->get<bool>();
}
std::optional<double> number_of(const Json& request, const char* key) {
  const auto found = request.find(key);
  return found != request.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

input::Reading<input::CaseFile> read_case(const Json& request, const Folders& folders) {
  const std::string text = request.contains("case") ? request["case"].dump() : "{}";
  return input::read_case_json(text, 0, name_of_case, "", folders.materials).read;
}

/// The standard with the values of the user; absent without one.
input::Reading<std::optional<injury::Standard>> read_standard(const Json& request, const Folders& folders) {
  const std::string name = text_of(request, "standard");
  if (name.empty()) return std::optional<injury::Standard>{};
  const input::StandardChoice choice = input::standard_choice(name);
  const auto file = input::find_standard(choice.name, folders.standards);
  if (!file) return file.faults();
  const auto standard = input::read_standard(*file);
  if (!standard) return standard.faults();
  for (const std::string& variant : choice.variants)
    if (std::ranges::find(standard->variants, variant, &injury::StandardVariant::name) ==
        standard->variants.end())
      return input::fault_of_file(name, "has no variant " + variant);
  const injury::UserValues values{.mass = number_of(request, "mass"),
                                  .radius = number_of(request, "radius"),
                                  .speed = number_of(request, "speed"),
                                  .drop_height = {}};
  return std::optional(injury::with_user_values(injury::with_variants(*standard, choice.variants), values));
}

/// Of the whole page, or of its lead alone, which takes a third of the time.
void add_page(const Json& request, const UnitSystem& units, output::Document document, Json& answer) {
  if (!is_set(request, "whole")) document.sections.clear();
  answer["title"] = document.lead->answer;
  answer["tone"] = output::class_of_tone(document.lead->tone);
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

Solution solved(const ImpactCase& impact, const Options& options, bool intervals,
                const std::vector<double>& dwell_levels = {}) {
  Solution solution = solve(impact, options);
  if (intervals) uncertainty::add_intervals(impact, options, solution, dwell_levels);
  return solution;
}

/// As `dashpad assess`: with what another choice of nose or speed would change, where intervals are asked
/// for.
void add_assessment(const Json& request, const injury::Standard& standard, const input::CaseFile& given,
                    const ImpactCase& impact, const Options& options, Json& answer) {
  const UnitSystem& units = unit_system(text_of(request, "units"));
  const bool intervals = is_set(request, "intervals");
  const Solution solution = solved(impact, options, intervals, injury::dwell_levels(standard));
  injury::Assessment assessment = injury::assess(standard, impact, solution);
  std::vector<injury::OtherChoice> others;
  if (intervals) {
    Options coarse = options;
    coarse.tolerance = 1e-3;
    others = injury::turning_choices(
        standard, given.impact, {}, assessment.verdict,
        [&](const injury::Standard& other, const ImpactCase& with) {
          return injury::assess(other, with, solved(with, coarse, true, injury::dwell_levels(other)));
        });
    for (const injury::OtherChoice& choice : others)
      assessment.reservations.push_back(output::other_choice(choice, standard, given.impact, units));
  }
  const output::AssessmentReport report{standard, given.impact, impact, solution, assessment, others};
  answer["result"] = Json::parse(output::assessment_json(report));
  add_page(request, units, output::assessment_document(report, units, output::Pictures::drawn), answer);
}

/// As `dashpad run`.
void add_impact(const Json& request, const ImpactCase& impact, const Options& options, Json& answer) {
  const UnitSystem& units = unit_system(text_of(request, "units"));
  std::vector<Blow> blows = solve_blows(impact, options);
  Solution& solution = blows.back().solution;
  if (is_set(request, "intervals")) uncertainty::add_intervals(impact, options, solution);
  const auto injury = injury::whole_pulse_figures(solution);
  output::ImpactReport report{impact, options, solution, injury};
  if (impact.blows) report.blows = output::blow_results(blows);
  answer["result"] = Json::parse(output::result_json(impact, solution.summary, injury, report.blows));
  if (is_set(request, "whole")) report.snapshots = contact_snapshots(blows.back().impact, solution.history);
  add_page(request, units, output::impact_document(report, units, output::Pictures::drawn), answer);
}

Json solve_case(const Json& request, const Folders& folders) {
  const auto given = read_case(request, folders);
  const auto standard = read_standard(request, folders);
  std::vector<input::Fault> faults = given.faults();
  std::ranges::copy(standard.faults(), std::back_inserter(faults));
  if (!faults.empty()) return faults_json(faults);
  const ImpactCase impact = *standard ? injury::with_impactor_of(**standard, given->impact) : given->impact;
  for (const Violation& violation : violations(impact))
    faults.push_back({.file = name_of_case,
                      .key = violation.key,
                      .value = fmt::format("{}", violation.value),
                      .rule = violation.rule});
  if (!faults.empty()) return faults_json(faults);
  Options options = given->options;
  constexpr double quick = 1e-3;
  if (is_set(request, "quick")) options.tolerance = std::max(options.tolerance, quick);
  Json answer;
  if (*standard)
    add_assessment(request, **standard, *given, impact, options, answer);
  else
    add_impact(request, impact, options, answer);
  answer["numbers"] = numbers_of(impact);
  answer["toml"] = toml_of(request["case"]);
  return answer;
}

Json solve_for(const Json& request, const Folders& folders) {
  const auto given = read_case(request, folders);
  if (!given) return faults_json(given.faults());
  const auto standard = read_standard(request, folders);
  if (!standard) return faults_json(standard.faults());
  if (!*standard) return fault_json("standard", "choose a standard, whose limits the pad is to keep");
  margin::Question question{.impacts = {}, .key = text_of(request, "key"), .unit = {}};
  question.options = given->options;
  const injury::Standard judged = injury::without_value_of(**standard, decided_by(question.key));
  question.impacts.push_back({.impact = injury::with_impactor_of(judged, given->impact), .standard = judged});
  if (const CaseQuantity* const quantity = quantities_of(given->impact).find(question.key))
    question.unit = quantity->unit;
  else
    return fault_json(question.key, "is no number of this case");
  if (!margin::choose_range(question)) return fault_json(question.key, "has no value to search about");
  const margin::Answer found = margin::solve_for(question);
  return {{"result", Json::parse(output::margin_json(found))},
          {"title", output::margin_answer(found, unit_system(text_of(request, "units")))}};
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
  const Json answer = what == "solve"       ? solve_case(asked, folders)
                      : what == "solve-for" ? solve_for(asked, folders)
                      : what == "read"      ? read_file(asked)
                      : what == "list"      ? list_all(folders)
                                            : fault_json("do", "must be solve, solve-for, read or list");
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace dashpad::live
