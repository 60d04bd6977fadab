#include "output/text/study_answer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "output/layout.hpp"
#include "output/text/capitals.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using study::StudyAnswers;
using Figures = std::vector<ValueRow>;
using AsText = std::function<std::string(double)>;

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

/// Values of that response with unit and three digits.
AsText in_unit_of(const std::string& response, const UnitSystem& units) {
  return [&response, &units](double value) { return three_digits(response, value, units); };
}

/// "95 % interval 10.1 to 14.2 %"; empty where there is none.
std::string interval_of(const study::Estimate& estimate, const AsText& shown) {
  const bool has_low = std::isfinite(estimate.low), has_high = std::isfinite(estimate.high);
  if (has_low && has_high)
    return fmt::format("95 % interval {} to {}", shown(estimate.low), shown(estimate.high));
  if (has_low) return "95 % interval above " + shown(estimate.low);
  if (has_high) return "95 % interval below " + shown(estimate.high);
  return "";
}

/// The response with the strictest limit, else the first of all.
std::size_t leading_response(const StudyAnswers& answers) {
  if (answers.limits.empty()) return 0;
  const std::string& limited = answers.limits[strictest_limit(answers)].response;
  for (std::size_t i = 0; i < answers.responses.size(); ++i)
    if (response_name(answers, i) == limited) return i;
  return 0;
}

/// Median and 95 % quantile of a response over draws, towards its limit.
void add_quantiles(Figures& figures, const StudyAnswers& answers, std::size_t response,
                   const UnitSystem& units) {
  const std::string& name = response_name(answers, response);
  const AsText shown = in_unit_of(name, units);
  const std::optional<double> limit = limit_of(answers, name);
  for (const auto& [probability, words] : {std::pair{0.5, "median"}, {0.95, "95 % quantile"}})
    if (const auto given = study::quantile(answers.groups.front().distributions[response], probability)) {
      ValueRow figure{.label = fmt::format("{}, {}", title_of(name), words),
                      .value = shown(given->value),
                      .remark = interval_of(*given, shown)};
      if (limit && *limit > 0 && std::isfinite(given->value)) {
        figure.share = given->value / *limit;
        figure.remark =
            fmt::format("limit {}{}{}", shown(*limit), figure.remark.empty() ? "" : "; ", figure.remark);
      }
      figures.push_back(std::move(figure));
    }
}

/// The range that holds 90 % of the draws, for each response but the leading one.
void add_spreads(Figures& figures, const StudyAnswers& answers, std::size_t leading,
                 const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const study::Distribution& distribution = answers.groups.front().distributions[i];
    const auto low = study::quantile(distribution, 0.05), high = study::quantile(distribution, 0.95);
    if (i == leading || !low || !high) continue;
    const std::string& name = response_name(answers, i);
    figures.push_back({.label = title_of(name),
                       .value = three_digit_range(name, low->value, high->value, units),
                       .remark = "90 % of the draws"});
  }
}

/// The least and the greatest median of each response over the combinations of levels.
void add_medians(Figures& figures, const StudyAnswers& answers, const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::string& name = response_name(answers, i);
    const auto [least, greatest] = extreme_medians(answers, i);
    const auto add = [&](const char* which, const StudyAnswers::OfGroup* of_group) {
      if (of_group != nullptr)
        figures.push_back(
            {.label = fmt::format("{}, {} median", title_of(name), which),
             .value = in_unit_of(name, units)(study::quantile(of_group->distributions[i], 0.5)->value),
             .remark = "at " + words_of_levels(answers, of_group->group, units)});
    };
    add("lowest", least);
    add("highest", greatest);
  }
}

/// The least peak of each thickness from the highest drop, of which the answer speaks.
void add_least_peaks(Figures& figures, const study::CushionCurves& curves, const UnitSystem& units) {
  const study::CushionCurves::Drop& drop = curves.drops.back();
  const AsText shown = [&](double value) { return three_digits("peak_acceleration", value, units); };
  for (const study::CushionCurve& curve : drop.curves)
    if (const std::optional<std::size_t> least = study::min_peak(curve))
      figures.push_back(
          {.label = fmt::format("Lowest peak on {}", brief_quantity(curve.thickness, "m", units, 3)),
           .value = shown(curve.peak_deceleration[*least]),
           .remark = fmt::format("at {}, drop height {}",
                                 brief_quantity(curve.static_stress[*least], "Pa", units, 3),
                                 brief_quantity(drop.height, "m", units, 3))});
}

/// The least and the greatest value of the leading response with where they are, and the range of others.
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
  add("lowest", least);
  if (least && values[*least] != values[*greatest]) add("highest", greatest);
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const study::Distribution& distribution = answers.groups.front().distributions[i];
    if (i == leading || distribution.rows == 0) continue;
    const std::string& other = response_name(answers, i);
    figures.push_back({.label = title_of(other),
                       .value = three_digit_range(other, distribution.least, distribution.greatest, units)});
  }
}

/// A share of the variance, with the few digits that its estimate supports.
std::string share_of_variance(double share) {
  return fmt::format("{:.{}f} %", 100 * share, share < 0.1 ? 1 : 0);
}

std::string part_of_rows(std::uint64_t count, std::uint64_t rows) {
  return fmt::format("{} of {} rows", count, rows);
}

/// A probability for each limit, or where levels vary the strictest limit at each of them.
void add_probabilities(Figures& figures, const StudyAnswers& answers, const UnitSystem& units) {
  constexpr std::size_t max_limits = 2, max_groups = 4;
  const bool has_levels = answers.groups.size() > 1;
  const std::size_t strictest = strictest_limit(answers);
  // The first and the last of the levels are among them.
  const std::size_t groups = std::min(answers.groups.size(), max_groups);
  for (std::size_t k = 0; k < groups; ++k) {
    const std::size_t place = groups < 2 ? 0 : k * (answers.groups.size() - 1) / (groups - 1);
    const StudyAnswers::OfGroup& group = answers.groups[place];
    for (std::size_t i = 0, shown = 0; i < answers.limits.size() && shown < max_limits; ++i) {
      const study::StudyLimit& limit = answers.limits[i];
      if (has_levels && i != strictest) continue;
      ++shown;
      const study::Exceedance& exceedance = group.exceedances[i];
      const std::string above = fmt::format("{} above {}", title_of(limit.response),
                                            in_unit_of(limit.response, units)(limit.value));
      ValueRow figure{.label = has_levels ? words_of_levels(answers, group.group, units) : above};
      figure.value = group.group.drawn ? per_cent(exceedance.probability.value)
                                       : part_of_rows(exceedance.exceeding, exceedance.rows);
      figure.remark = has_levels ? above : "";
      const std::string interval = group.group.drawn ? interval_of(exceedance.probability, per_cent)
                                   : exceedance.undecided > 0
                                       ? fmt::format("{} undecided", exceedance.undecided)
                                       : "";
      if (!interval.empty()) figure.remark += (figure.remark.empty() ? "" : "; ") + interval;
      figures.push_back(std::move(figure));
    }
  }
}

void add_indices(Figures& figures, const StudyAnswers& answers) {
  constexpr std::size_t max_factors = 4;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const auto& of = answers.groups.front().sensitivities[i];
    if (!of || of->indices.empty()) continue;
    std::vector<study::Sensitivity::Index> indices = of->indices;
    std::ranges::stable_sort(indices, std::ranges::greater(),
                             [](const study::Sensitivity::Index& index) { return index.total.value; });
    for (const study::Sensitivity::Index& index : indices)
      if (figures.size() < max_factors)
        figures.push_back(
            {.label = fmt::format("{}, due to the {}", title_of(response_name(answers, i)),
                                  factor_words(index.factor)),
             .value = share_of_variance(std::max(index.total.value, 0.0)),
             .remark = fmt::format("of the variance; {}", interval_of(index.total, share_of_variance))});
    return;
  }
}

/// Counts that qualify the answer: rows that bottomed out or went beyond the tests of the foam.
void add_counts(Figures& figures, const StudyAnswers& answers) {
  const std::uint64_t rows = answers.records.rows.size();
  const auto add = [&](const char* label, std::uint64_t count, Tone tone) {
    if (count > 0 && rows > 0)
      figures.push_back({.label = label,
                         .value = per_cent(static_cast<double>(count) / static_cast<double>(rows)),
                         .remark = part_of_rows(count, rows),
                         .tone = tone});
  };
  add("Bottomed out", answers.records.struck_through, Tone::bad);
  add("Beyond the tested strain", answers.records.beyond_strain, Tone::doubtful);
  add("Beyond the tested rates", answers.records.beyond_rate, Tone::plain);
}

}  // namespace

std::vector<ValueRow> study_key_figures(const StudyAnswers& answers, const UnitSystem& units) {
  Figures figures;
  if (answers.groups.empty() || answers.responses.empty() || answers.records.rows.empty()) return figures;
  const bool drawn = answers.groups.front().group.drawn;
  if (!answers.limits.empty())
    add_probabilities(figures, answers, units);
  else
    add_indices(figures, answers);
  if (answers.cushion_curves && !answers.cushion_curves->drops.empty())
    add_least_peaks(figures, *answers.cushion_curves, units);
  else if (answers.groups.size() == 1 && drawn) {
    add_quantiles(figures, answers, leading_response(answers), units);
    add_spreads(figures, answers, leading_response(answers), units);
  } else if (answers.groups.size() == 1)
    add_ranges(figures, answers, units);
  else if (drawn && answers.limits.empty())
    add_medians(figures, answers, units);
  // The counts always keep their places; the other figures give way.
  Figures counts;
  add_counts(counts, answers);
  figures.resize(std::min(figures.size(), max_key_figures - counts.size()));
  figures.insert(figures.end(), counts.begin(), counts.end());
  return figures;
}

}  // namespace dashpad::output
