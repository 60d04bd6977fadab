#include "solve_for/question.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/study/study_file.hpp"
#include "input/measurement/measurement_text.hpp"
#include "margin/question_text.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

using Complaints = std::vector<std::string>;

/// "A..B" in SI.
std::optional<std::pair<double, double>> range_of(const std::string& option, const std::string& text,
                                                  const std::string& unit, Complaints& errors) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos || dots == 0 || text.find("..", dots + 2) != std::string::npos) {
    errors.push_back(fmt::format(R"({} "{}": must be a range such as "10 mm..60 mm")", option, text));
    return std::nullopt;
  }
  const auto low = quantity_of(option.c_str(), text.substr(0, dots), unit, errors);
  const auto high = quantity_of(option.c_str(), text.substr(dots + 2), unit, errors);
  if (!low || !high) return std::nullopt;
  if (*low < *high) return std::pair(*low, *high);
  errors.push_back(fmt::format(R"({} "{}": the range must begin below its end)", option, text));
  return std::nullopt;
}

/// The factor that one of these keys names, with its unit.
const study::FactorKey* known_key(const std::vector<study::FactorKey>& known, const std::string& key) {
  const auto found = std::ranges::find(known, key, &study::FactorKey::key);
  return found == known.end() ? nullptr : &*found;
}

/// A factor of --vary: "5 %", "A..B" or "M +- S".
std::optional<study::Factor> factor_of(const std::string& text, const std::vector<study::FactorKey>& known,
                                       const ImpactCase& impact, Complaints& errors) {
  const std::size_t sign = text.find('=');
  const std::string key = text.substr(0, sign);
  const std::string option = "--vary " + key;
  const study::FactorKey* const of = known_key(known, key);
  if (key.starts_with("foam.")) {
    errors.push_back(option +
                     ": --vary foam draws all that the card leaves uncertain; for one source of it, draw in "
                     "a study and give its file");
    return std::nullopt;
  }
  if (of == nullptr || of->unit.empty()) {
    errors.push_back(option + ": " +
                     (of == nullptr ? study::rule_for_unknown(key, impact, known) : "is not a number"));
    return std::nullopt;
  }
  if (sign == std::string::npos || sign + 1 == text.size()) {
    errors.push_back(option + R"(: must be followed by its scatter, as in pad.scale="5 %" or "A..B")");
    return std::nullopt;
  }
  const std::string spread = text.substr(sign + 1);
  study::Factor factor{.key = key, .unit = of->unit, .lowest = {}, .highest = {}};
  if (const std::size_t between = spread.find("+-"); between != std::string::npos) {
    const auto mean = quantity_of(option.c_str(), spread.substr(0, between), of->unit, errors);
    const bool is_share = spread.find('%', between) != std::string::npos;
    const std::string width(input::without_blanks(spread.substr(between + 2)));
    const auto deviation = positive_quantity_of(option.c_str(), width, is_share ? "1" : of->unit, errors);
    if (!mean || !deviation) return std::nullopt;
    factor.spread = study::Normal{*mean, is_share ? *deviation * std::abs(*mean) : *deviation};
  } else if (spread.find("..") != std::string::npos) {
    const auto range = range_of(option, spread, of->unit, errors);
    if (!range) return std::nullopt;
    factor.spread = study::Uniform{range->first, range->second};
  } else if (spread.find('%') != std::string::npos) {
    const auto share = positive_quantity_of(option.c_str(), spread, "1", errors);
    const double value = case_value(impact, key);
    if (share && !(std::abs(value) > 0)) {
      errors.push_back(option +
                       R"(: the case has no value to take a percentage of; give "M +- S" or "A..B")");
      return std::nullopt;
    }
    if (!share) return std::nullopt;
    factor.spread = study::Normal{value, *share * std::abs(value)};
  } else {
    errors.push_back(fmt::format(R"({}: "{}" is not a valid scatter; give a percentage, "A..B" or "M +- S")",
                                 option, spread));
    return std::nullopt;
  }
  return factor;
}

/// Adds what a study draws, with its correlations. Its levels and its case are left out.
void add_draws_of(const study::Study& study, margin::Chance& chance) {
  std::vector<std::optional<std::size_t>> places;
  for (const study::Factor& factor : study.factors) {
    places.emplace_back(factor.is_sampled() ? std::optional(chance.factors.size()) : std::nullopt);
    if (factor.is_sampled()) chance.factors.push_back(factor);
  }
  for (const study::Correlation& correlation : study.correlations)
    if (places[correlation.first] && places[correlation.second])
      chance.correlations.push_back(
          {*places[correlation.first], *places[correlation.second], correlation.value});
}

}  // namespace

margin::Question question_of(const SolveForRequest& request) {
  Complaints errors;
  margin::Question question{
      .impacts = {}, .key = request.key, .unit = {}, .intervals = !request.no_intervals};
  const std::optional<double> tolerance = tolerance_of(request.tolerance, errors);
  std::vector<margin::Limit> limits;
  for (const std::string& text : request.until)
    if (const auto limit = taken(margin::read_limit(text), errors)) limits.push_back(*limit);
  std::vector<input::InputFile> files;
  std::vector<injury::Standard> standards;
  for (const std::string& name : request.standards)
    if (const auto standard = standard_of(name, chosen_standards(request.standard_folder), files, errors))
      standards.push_back(injury::without_value_of(*standard, decided_by(request.key)));
  if (request.until.empty() && request.standards.empty())
    errors.emplace_back("no limit: give --standard or --until");
  const std::optional<double> probability =
      positive_quantity_of("--probability", request.probability, "1", errors);
  if (request.vary.empty() && (probability || request.draws || request.seed))
    errors.push_back(
        fmt::format("{}: needs --vary, to say what scatters, or --vary foam", probability ? "--probability"
                                                                              : request.draws ? "--draws"
                                                                                              : "--seed"));
  add_lines(margin::faults_of_aims(limits, standards.size() + request.vary.size()), errors);
  const std::optional<input::CaseFile> given = read_case(request.given, errors);
  for (const input::InputFile& file : files_of(request.given.file, given)) files.push_back(file);
  judge_files(request.files, files, errors);
  judge_picture(request.files, errors);
  if (!given) throw Refused(std::move(errors));

  question.options = given->options;
  if (tolerance) question.options.tolerance = *tolerance;
  for (const injury::Standard& standard : standards)
    question.impacts.push_back(
        {.impact = injury::with_impactor_of(standard, given->impact), .standard = standard});
  if (!limits.empty())
    question.impacts.push_back(margin::judged_by(std::move(limits), given->impact, request.key));

  const std::vector<study::FactorKey> known = study::factor_keys(given->impact);
  const study::FactorKey* const key = known_key(known, request.key);
  if (key == nullptr)
    errors.push_back(
        fmt::format("{}: {}", request.key, study::rule_for_unknown(request.key, given->impact, known)));
  else if (key->unit.empty())
    errors.push_back(request.key + ": is not a number; compare materials in a study (docs/studies.md)");
  else
    question.unit = key->unit;
  if (!request.vary.empty()) {
    question.chance = {.probability = probability.value_or(0.95),
                       .factors = {},
                       .draws = request.draws.value_or(1024),
                       .seed = request.seed.value_or(1)};
    for (const std::string& text : request.vary) {
      if (text == "foam") {
        question.chance->foam = true;
      } else if (text.ends_with(".toml")) {
        if (const auto study = taken(study::read_study(text, chosen_folder(request.given.materials),
                                                       chosen_standards(request.standard_folder)),
                                     errors))
          add_draws_of(*study, *question.chance);
      } else if (const auto factor = factor_of(text, known, given->impact, errors)) {
        question.chance->factors.push_back(*factor);
      }
    }
  }
  if (question.chance)
    for (const study::Factor& factor : question.chance->factors)
      if (factor.key == request.key)
        errors.push_back(
            fmt::format("--vary {}: the number being solved for cannot also be drawn", factor.key));
  if (request.between && key != nullptr)
    if (const auto range = range_of("--between", *request.between, key->unit, errors)) {
      question.low = range->first, question.high = range->second;
      question.logarithmic = range->first > 0 && range->second > 4 * range->first;
    }
  if (errors.empty() && !request.between && !margin::choose_range(question))
    errors.push_back(fmt::format("{}: the case has no value above 0 to search about; give --between \"A..B\"",
                                 request.key));
  if (errors.empty()) add_lines(margin::faults_of(question), errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  return question;
}

margin::Answer solve_for_with_progress(const margin::Question& question) {
  ProgressLine line{"Searching"};
  constexpr std::size_t all = 1000;
  return margin::solve_for(question, [&line](double share) {
    line.show(static_cast<std::size_t>(share * static_cast<double>(all)), all);
    return true;
  });
}

}  // namespace dashpad::app
