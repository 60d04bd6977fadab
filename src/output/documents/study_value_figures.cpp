#include "output/documents/study_value_figures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "output/text/study_answer.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using study::StudyAnswers;
using Figures = std::vector<ValueRow>;

std::optional<double> limit_of(const StudyAnswers& answers, const std::string& response) {
  const auto found = std::ranges::find(answers.limits, response, &study::StudyLimit::response);
  return found == answers.limits.end() ? std::nullopt : std::optional(found->value);
}

/// "at impact speed 5 m/s, thickness of the pad 30 mm" of a row.
std::string factors_of(const StudyAnswers& answers, std::size_t place, const UnitSystem& units) {
  std::string text;
  for (std::size_t i = 0; i < answers.study.factors.size(); ++i)
    text += (i == 0 ? "at " : ", ") + factor_at(answers.study, i, answers.records.factors[i][place], units);
  return text;
}

}  // namespace

AsText in_unit_of(const std::string& response, const UnitSystem& units) {
  return [&response, &units](double value) { return three_digits(response, value, units); };
}

std::string interval_of(const study::Estimate& of, const AsText& shown) {
  const bool has_low = std::isfinite(of.low), has_high = std::isfinite(of.high);
  if (has_low && has_high) return fmt::format("95 % interval {} to {}", shown(of.low), shown(of.high));
  if (has_low) return "95 % interval above " + shown(of.low);
  if (has_high) return "95 % interval below " + shown(of.high);
  return "";
}

std::size_t leading_response(const StudyAnswers& answers) {
  if (answers.limits.empty()) return 0;
  const std::string& limited = answers.limits[strictest_limit(answers)].response;
  for (std::size_t i = 0; i < answers.responses.size(); ++i)
    if (response_name(answers, i) == limited) return i;
  return 0;
}

void add_quantiles(Figures& figures, const StudyAnswers& answers, std::size_t response,
                   const UnitSystem& units) {
  const std::string& name = response_name(answers, response);
  const AsText shown = in_unit_of(name, units);
  const std::optional<double> limit = limit_of(answers, name);
  for (const auto& [probability, words] :
       {std::pair{0.5, "half of the draws below"}, {0.95, "95 % of the draws below"}})
    if (const auto of = study::quantile(answers.groups.front().distributions[response], probability)) {
      ValueRow figure{.label = fmt::format("{}, {}", title_of(name), words),
                      .value = shown(of->value),
                      .remark = interval_of(*of, shown)};
      if (limit && *limit > 0 && std::isfinite(of->value)) {
        figure.share = of->value / *limit;
        figure.remark =
            fmt::format("limit {}{}{}", shown(*limit), figure.remark.empty() ? "" : "; ", figure.remark);
      }
      figures.push_back(std::move(figure));
    }
}

void add_spreads(Figures& figures, const StudyAnswers& answers, std::size_t leading,
                 const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const study::Distribution& of = answers.groups.front().distributions[i];
    const auto low = study::quantile(of, 0.05), high = study::quantile(of, 0.95);
    if (i == leading || !low || !high) continue;
    const std::string& name = response_name(answers, i);
    figures.push_back({.label = title_of(name),
                       .value = three_digit_range(name, low->value, high->value, units),
                       .remark = "nine draws in ten"});
  }
}

void add_medians(Figures& figures, const StudyAnswers& answers, const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::string& name = response_name(answers, i);
    const auto [least, greatest] = extreme_medians(answers, i);
    const auto add = [&](const char* which, const StudyAnswers::OfGroup* of) {
      if (of != nullptr)
        figures.push_back(
            {.label = fmt::format("{}, {} median", title_of(name), which),
             .value = in_unit_of(name, units)(study::quantile(of->distributions[i], 0.5)->value),
             .remark = "at " + words_of_levels(answers, of->group, units)});
    };
    add("least", least);
    add("greatest", greatest);
  }
}

void add_least_peaks(Figures& figures, const study::CushionCurves& curves, const UnitSystem& units) {
  const study::CushionCurves::Drop& drop = curves.drops.back();
  const AsText shown = [&](double value) { return three_digits("peak_acceleration", value, units); };
  for (const study::CushionCurve& curve : drop.curves)
    if (const std::optional<std::size_t> least = study::least_peak(curve))
      figures.push_back(
          {.label = fmt::format("Least peak on {}", brief_quantity(curve.thickness, "m", units, 3)),
           .value = shown(curve.peak_deceleration[*least]),
           .remark =
               fmt::format("at {}, from {}", brief_quantity(curve.static_stress[*least], "Pa", units, 3),
                           brief_quantity(drop.height, "m", units, 3))});
}

void add_ranges(Figures& figures, const StudyAnswers& answers, const UnitSystem& units) {
  const std::size_t leading = leading_response(answers);
  const study::Group& group = answers.groups.front().group;
  const std::string& name = response_name(answers, leading);
  const std::vector<double> values =
      study::values_of(answers.study, answers.records, group, answers.responses[leading]);
  std::optional<std::size_t> least, greatest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    if (!least || values[i] < values[*least]) least = i;
    if (!greatest || values[i] > values[*greatest]) greatest = i;
  }
  const std::optional<double> limit = limit_of(answers, name);
  const auto add = [&](const char* which, std::optional<std::size_t> at) {
    if (!at) return;
    const bool is_single = values[*least] == values[*greatest];
    ValueRow figure{
        .label = title_of(name) + (is_single ? "" : fmt::format(", {}", which)),
        .value = in_unit_of(name, units)(values[*at]),
        .remark = std::isfinite(values[*at]) ? factors_of(answers, group.places[*at], units) : ""};
    if (limit && *limit > 0 && std::isfinite(values[*at])) figure.share = values[*at] / *limit;
    figures.push_back(std::move(figure));
  };
  add("least", least);
  if (least && values[*least] != values[*greatest]) add("greatest", greatest);
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const study::Distribution& of = answers.groups.front().distributions[i];
    if (i == leading || of.rows == 0) continue;
    const std::string& other = response_name(answers, i);
    figures.push_back(
        {.label = title_of(other), .value = three_digit_range(other, of.least, of.greatest, units)});
  }
}

}  // namespace dashpad::output
