// The question: its limits, the study of each of its impacts, and the rules that it may break.

#include <algorithm>
#include <cmath>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/study/responses.hpp"
#include "margin/evaluation.hpp"

namespace dashpad::margin {

namespace {

void add_limits(const Judged& judged, std::vector<Limit>& limits) {
  if (judged.standard)
    for (const injury::Criterion& criterion : judged.standard->criteria)
      limits.push_back({.figure = criterion.quantity,
                        .level = criterion.has_level() ? criterion.level : 0,
                        .value = criterion.limit,
                        .title = injury::title_of(criterion),
                        .origin = judged.standard->name});
  limits.insert(limits.end(), judged.limits.begin(), judged.limits.end());
}

}  // namespace

std::vector<Limit> limits_of(const Question& question) {
  std::vector<Limit> limits;
  for (const Judged& judged : question.impacts) add_limits(judged, limits);
  return limits;
}

bool is_aim(const Question& question) {
  const std::vector<Limit> limits = limits_of(question);
  return limits.size() == 1 && limits.front().is_aim && !question.chance;
}

study::Study study_of(const Question& question, const Judged& judged, std::vector<double> values) {
  study::Study study;
  study.base = judged.impact;
  study.options = question.options;
  study.factors = {{.key = question.key,
                    .unit = question.unit,
                    .spread = study::Levels{std::move(values)},
                    .lowest = {},
                    .highest = {}}};
  if (question.chance) {
    study.options.tolerance = std::max(study.options.tolerance, 1e-3);
    study.factors.insert(study.factors.end(), question.chance->factors.begin(),
                         question.chance->factors.end());
    for (const study::Correlation& correlation : question.chance->correlations)
      study.correlations.push_back({correlation.first + 1, correlation.second + 1, correlation.value});
    if (question.chance->foam) study::draw_foam_uncertainty(study);
    study.samples = question.chance->draws;
    study.seed = question.chance->seed;
  }
  std::vector<Limit> limits;
  add_limits(judged, limits);
  for (const Limit& limit : limits) study.responses.emplace_back(limit.figure->key);
  return study;
}

bool choose_range(Question& question) {
  const double value = case_value(question.impacts.front().impact, question.key);
  if (!(value > 0)) return false;
  question.logarithmic = true;
  const auto is_sound = [&](double low, double high) {
    question.low = low, question.high = high;
    return violations(question).empty();
  };
  double down = 4, up = 4;
  while (down > 1.01 && !is_sound(value / down, value)) down = 1 + (down - 1) / 2;
  while (up > 1.01 && !is_sound(value, value * up)) up = 1 + (up - 1) / 2;
  question.low = value / down, question.high = value * up;
  return true;
}

const char* to_string(Zone zone) {
  constexpr const char* names[]{"pass", "fail", "undecided", "unknown"};
  return names[static_cast<std::size_t>(zone)];
}

std::vector<Violation> violations(const Question& question) {
  std::vector<Violation> broken;
  if (!(question.low < question.high) || !std::isfinite(question.low) || !std::isfinite(question.high))
    return {{"--between", question.low, "the range must begin below its end"}};
  if (question.logarithmic && !(question.low > 0))
    return {{"--between", question.low, "equal ratios need a range above 0"}};
  for (const Limit& limit : limits_of(question))
    if (limit.value == 0 || !std::isfinite(limit.value))
      broken.push_back({"--until", limit.value, "the limit must be a finite number other than 0"});
  if (limits_of(question).empty()) broken.push_back({"--standard", 0, "a limit is needed"});
  if (const auto& chance = question.chance) {
    if (!(chance->probability >= 0.5 && chance->probability <= 0.9991))
      broken.push_back({"--probability", chance->probability, "must lie between 50 % and 99.9 %"});
    for (const Limit& limit : limits_of(question))
      if (study::find_response_kind(limit.figure->key) == nullptr)
        broken.push_back({"--probability", chance->probability,
                          "draws have no " + title_in_sentence(*limit.figure) + ", which is limited"});
  }
  if (!broken.empty()) return broken;
  for (const Judged& judged : question.impacts) {
    study::Study study = study_of(question, judged, {question.low, question.high});
    if (study.responses.empty() || !question.chance) study.responses = study::default_responses();
    for (const Violation& violation : study::violations(study)) broken.push_back(violation);
  }
  return broken;
}

}  // namespace dashpad::margin
