#include "live/request.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/study/study.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "input/fault_json.hpp"
#include "input/option_values.hpp"
#include "live/case_tables.hpp"
#include "margin/question_text.hpp"
#include "output/page/html.hpp"
#include "output/page/html_elements.hpp"

namespace dashpad::live {

namespace {

using Faults = std::vector<input::Fault>;

template <class T>
std::optional<T> taken(input::Reading<T> reading, Faults& faults) {
  if (reading) return *std::move(reading);
  add(reading.faults(), faults);
  return std::nullopt;
}

/// As a text or a number; absent if it is that of the case.
std::optional<double> tolerance_of(const Json& request, Faults& faults) {
  const std::string text = text_of(request, "tolerance");
  return text.empty() ? number_of(request, "tolerance") : taken(input::read_tolerance(text), faults);
}

injury::UserValues user_values(const Json& request, Faults& faults) {
  return {.mass = value_of(request, "mass", "--mass", "kg", faults),
          .radius = value_of(request, "radius", "--radius", "m", faults),
          .speed = value_of(request, "speed", "--speed", "m/s", faults),
          .drop_height = value_of(request, "drop_height", "--drop-height", "m", faults)};
}

}  // namespace

void add(const std::vector<input::Fault>& more, std::vector<input::Fault>& faults) {
  std::ranges::copy(more, std::back_inserter(faults));
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
std::vector<std::string> texts_of(const Json& request, const char* key) {
  std::vector<std::string> texts;
  if (const auto found = request.find(key); found != request.end() && found->is_array())
    for (const Json& each : *found)
      if (each.is_string()) texts.push_back(each.get<std::string>());
  return texts;
}
std::optional<double> value_of(const Json& request, const char* key, const char* option, const char* unit,
                               Faults& faults) {
  const std::string text = text_of(request, key);
  if (text.empty()) return number_of(request, key);
  return taken(input::read_positive_option(option, text, unit), faults);
}
const UnitSystem& units_of(const Json& request) {
  const std::string name = text_of(request, "units");
  const auto known = std::ranges::find(unit_systems(), name, &UnitSystem::name);
  return known == unit_systems().end() ? unit_systems().front() : *known;
}

Folders folders_of(const Json& request, const Folders& own) {
  const std::string materials = text_of(request, "materials"), standards = text_of(request, "standards");
  return {.materials = materials.empty() ? own.materials : std::filesystem::path(materials),
          .standards = standards.empty() ? own.standards : std::filesystem::path(standards)};
}

Json faults_json(const std::vector<input::Fault>& faults) {
  std::vector<std::string> lines;
  std::ranges::transform(faults, std::back_inserter(lines), input::with_excerpt);
  return {{"faults", array_of(faults,
                              [](const input::Fault& fault) {
                                Json data = dashpad::fault_json(fault);
                                data["text"] = with_excerpt(fault);
                                return data;
                              })},
          {"lines", input::abridged(lines)}};
}
Json fault_json(const std::string& key, const std::string& rule) {
  return faults_json({{.file = name_of_case, .key = key, .value = "", .rule = rule}});
}

input::Reading<input::CaseFile> read_case(const Json& request, const Folders& folders) {
  const std::vector<std::string> settings = texts_of(request, "set");
  if (const std::string file = text_of(request, "file"); !file.empty())
    return input::read_case(file, folders.materials, settings);
  if (!settings.empty() && request.contains("case"))
    return input::read_case_text(toml_of(request["case"]), name_of_case, folders.materials, settings);
  const std::string text = request.contains("case") ? request["case"].dump() : "{}";
  return input::read_case_json(text, 0, name_of_case, "", folders.materials).read;
}

input::Reading<std::optional<injury::Standard>> read_standard(const Json& request, const Folders& folders) {
  const std::string name = text_of(request, "standard");
  if (name.empty()) return std::optional<injury::Standard>{};
  const input::StandardChoice choice = input::standard_choice(name);
  const auto file = input::find_standard(choice.name, folders.standards);
  if (!file) return file.faults();
  const auto standard = input::read_standard(*file);
  if (!standard) return standard.faults();
  for (const std::string& variant : choice.variants) {
    if (std::ranges::find(standard->variants, variant, &injury::StandardVariant::name) !=
        standard->variants.end())
      continue;
    std::string names;
    for (const injury::StandardVariant& known : standard->variants)
      names += (names.empty() ? "its variants are " : ", ") + known.name;
    return input::fault_of_file("--standard", fmt::format("{} has no variant \"{}\"; {}", standard->name,
                                                          variant, names.empty() ? "it has none" : names));
  }
  return std::optional(injury::with_variants(*standard, choice.variants));
}

std::optional<input::InputFile> standard_file(const Json& request, const Folders& folders) {
  const std::string name = text_of(request, "standard");
  if (name.empty()) return std::nullopt;
  const auto file = input::find_standard(input::standard_choice(name).name, folders.standards);
  return file ? std::optional(input::InputFile{"the standard", *file}) : std::nullopt;
}

input::Reading<Asked> read_asked(const Json& request, const Folders& folders) {
  Faults faults;
  Asked asked{.name = request.contains("file") ? text_of(request, "file") : name_of_case};
  const std::optional<double> tolerance = tolerance_of(request, faults);
  for (const std::string& text : texts_of(request, "until"))
    if (auto limit = taken(margin::read_limit(text), faults)) asked.limits.push_back(*std::move(limit));
  asked.kept = {.nose = is_set(request, "keep_nose"), .speed = is_set(request, "keep_speed")};
  const injury::UserValues values = user_values(request, faults);
  const auto standard = read_standard(request, folders);
  if (!standard)
    add(standard.faults(), faults);
  else if (*standard)
    asked.own = injury::with_user_values(**standard, values);
  add(margin::faults_of_aims(asked.limits, asked.own ? 1 : 0), faults);
  auto given = read_case(request, folders);
  if (!given) add(given.faults(), faults);
  if (!faults.empty()) return faults;

  asked.given = *std::move(given);
  if (tolerance) asked.given.options.tolerance = *tolerance;
  asked.impact = asked.given.impact;
  if (!asked.own) return asked;
  asked.standard = injury::with_kept(*asked.own, asked.impact.impactor, asked.kept);
  asked.impact = injury::with_impactor_of(*asked.standard, asked.given.impact);
  for (const Violation& violation : violations(asked.impact))
    faults.push_back({.file = fmt::format("{}, with the impactor of {}", asked.name, asked.standard->name),
                      .key = violation.key,
                      .value = fmt::format("{}", violation.value),
                      .rule = violation.rule});
  if (!faults.empty()) return faults;
  return asked;
}

std::vector<Blow> solved_blows(const Json& request, const Asked& asked, const Options& options) {
  const auto& standard = asked.standard;
  std::vector<Blow> blows = standard ? std::vector{Blow{asked.impact, solve(asked.impact, options)}}
                                     : solve_blows(asked.impact, options);
  if (is_set(request, "intervals"))
    uncertainty::add_intervals(asked.impact, options, blows.back().solution,
                               standard ? injury::dwell_levels(*standard) : std::vector<double>{});
  return blows;
}

input::Reading<margin::Question> read_question(const Json& request, const Folders& folders) {
  const auto asked = read_asked(request, folders);
  if (!asked) return asked.faults();
  if (!asked->standard && asked->limits.empty())
    return Faults{{.file = name_of_case,
                   .key = "standard",
                   .value = "",
                   .rule = "choose a standard, whose limits the pad is to keep"}};
  const ImpactCase& given = asked->given.impact;
  margin::Question question{.impacts = {}, .key = text_of(request, "key"), .unit = {}};
  question.options = asked->given.options;
  if (request.contains("intervals")) question.intervals = is_set(request, "intervals");
  if (asked->standard) {
    const injury::Standard judged = injury::without_value_of(*asked->standard, decided_by(question.key));
    question.impacts.push_back({.impact = injury::with_impactor_of(judged, given), .standard = judged});
  }
  if (!asked->limits.empty())
    question.impacts.push_back(margin::judged_by(asked->limits, given, question.key));
  const auto refused = [&](const std::string& rule) {
    return Faults{{.file = question.key, .key = "", .value = "", .rule = rule}};
  };
  const std::vector<study::FactorKey> known = study::factor_keys(given);
  const auto key = std::ranges::find(known, question.key, &study::FactorKey::key);
  if (key == known.end()) return refused(study::rule_for_unknown(question.key, given, known));
  if (key->unit.empty()) return refused("is not a number; compare materials in a study (docs/studies.md)");
  question.unit = key->unit;
  if (!margin::choose_range(question)) return refused("the case has no value above 0 to search about");
  if (auto faults = margin::faults_of(question); !faults.empty()) return faults;
  return question;
}

void add_page(Json& answer, output::Document document, const UnitSystem& units) {
  answer["title"] = document.lead->answer;
  answer["tone"] = output::class_of_tone(document.lead->tone);
  answer["html"] = output::html_of({{&units, std::move(document)}}).body;
}

Json list_all(const Folders& folders) {
  Json list{{"foams", Json::array()}, {"standards", Json::array()}};
  if (const auto cards = input::list_materials(folders.materials))
    for (const std::filesystem::path& card : *cards)
      if (const auto material = input::read_material(card))
        list["foams"].push_back({{"name", material->name}, {"title", material->title}});
  if (const auto files = input::list_standards(folders.standards))
    for (const std::filesystem::path& file : *files)
      if (const auto standard = input::read_standard(file)) {
        const auto name = [](const injury::StandardVariant& variant) { return Json(variant.name); };
        const auto title = [](const injury::StandardVariant& variant) { return Json(variant.title); };
        list["standards"].push_back({{"name", standard->name},
                                     {"title", standard->title},
                                     {"variants", array_of(standard->variants, name)},
                                     {"variant_titles", array_of(standard->variants, title)}});
      }
  return list;
}

std::string answered(std::string_view request, const std::function<Json(const Json&)>& answer_to) {
  constexpr std::size_t max_request = std::size_t{1} << 20;
  if (request.size() > max_request) return fault_json("", "is larger than 1 MiB").dump();
  const Json asked = Json::parse(request, nullptr, false);
  if (!asked.is_object()) return fault_json("", "is not a request").dump();
  return answer_to(asked).dump(-1, ' ', false, Json::error_handler_t::replace);
}

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

}  // namespace dashpad::live
