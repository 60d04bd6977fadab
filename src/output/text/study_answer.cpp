#include "output/text/study_answer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "output/text/capitals.hpp"
#include "output/text/factor_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string value_of(const std::string& response, double value, const UnitSystem& units) {
  return three_digits(response, value, units);
}

std::string per_cent(double share) { return brief(100 * share, 3) + " %"; }

/// Of the first limit.
std::string limit_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  const study::StudyLimit& limit = answers.limits.front();
  const std::string exceeded = fmt::format("{} exceeds {}", uncapitalised(title_of(limit.response)),
                                           brief_quantity(limit.value, si_unit_of(limit.response), units));
  if (answers.groups.size() == 1 && answers.groups.front().group.drawn) {
    const study::Estimate& of = answers.groups.front().exceedances.front().probability;
    if (!std::isfinite(of.value)) return fmt::format("Whether {} is undecided", exceeded);
    return fmt::format("In {} of cases {} ({} to {})", per_cent(of.value), exceeded, per_cent(of.low),
                       per_cent(of.high));
  }
  std::uint64_t exceeding = 0, rows = 0;
  for (const study::StudyAnswers::OfGroup& group : answers.groups) {
    exceeding += group.exceedances.front().exceeding;
    rows += group.exceedances.front().rows;
  }
  return fmt::format("In {} of {} rows {}", exceeding, rows, exceeded);
}

/// Of the first response with indices; empty without any.
std::string index_answer(const study::StudyAnswers& answers) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const auto& of = answers.groups.front().sensitivities[i];
    if (!of || of->indices.empty()) continue;
    const auto most = std::ranges::max_element(
        of->indices, {}, [](const study::Sensitivity::Index& index) { return index.total.value; });
    return fmt::format("{} follows {} most: {} of its scatter", title_of(response_name(answers, i)),
                       factor_words(most->factor), per_cent(std::clamp(most->total.value, 0.0, 1.0)));
  }
  return "";
}

/// Of the first response over a grid.
std::string range_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string& name = response_name(answers, 0);
  const study::Distribution& of = answers.groups.front().distributions.front();
  if (of.rows == 0) return "";
  if (of.struck_through > 0)
    return fmt::format("{} goes from {} to bottoming out", title_of(name), value_of(name, of.least, units));
  return fmt::format("{} goes from {}", title_of(name),
                     three_digit_range(name, of.least, of.greatest, units));
}

/// Where the curves of the highest drop are lowest.
std::string cushion_answer(const study::CushionCurves& curves, const UnitSystem& units) {
  const auto drop = std::ranges::max_element(curves.drops, {}, &study::CushionCurves::Drop::height);
  std::string minima;
  for (const study::CushionCurve& curve : drop->curves) {
    std::size_t least = curve.peak_deceleration.size();
    for (std::size_t i = 0; i < curve.peak_deceleration.size(); ++i)
      if (const double value = curve.peak_deceleration[i];
          std::isfinite(value) &&
          (least == curve.peak_deceleration.size() || value < curve.peak_deceleration[least]))
        least = i;
    if (least == curve.peak_deceleration.size()) continue;
    minima += fmt::format("{}{} on {} (at {})", minima.empty() ? "" : ", ",
                          value_of("peak_acceleration", curve.peak_deceleration[least], units),
                          brief_quantity(curve.thickness, "m", units, 3),
                          brief_quantity(curve.static_stress[least], "Pa", units, 3));
  }
  return minima.empty() ? ""
                        : fmt::format("From {}, the least peaks are {}",
                                      brief_quantity(drop->height, "m", units, 3), minima);
}

std::string spread_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string& name = response_name(answers, 0);
  const auto& quantiles = answers.groups.front().distributions.front().quantiles;
  const auto at = [&](double probability) {
    const auto found = std::ranges::find(quantiles, probability, &study::Distribution::Quantile::probability);
    if (found == quantiles.end() || std::isnan(found->value.value)) return std::string("unknown");
    return std::isfinite(found->value.value) ? value_of(name, found->value.value, units) : "bottomed out";
  };
  return fmt::format("{}: half of the draws below {}, 95 % below {}", title_of(name), at(0.5), at(0.95));
}

}  // namespace

std::string study_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  if (answers.groups.empty() || answers.responses.empty() || answers.records.rows.empty()) return "";
  if (!answers.limits.empty()) return limit_answer(answers, units);
  if (std::string indices = index_answer(answers); !indices.empty()) return indices;
  if (answers.cushion_curves && !answers.cushion_curves->drops.empty())
    return cushion_answer(*answers.cushion_curves, units);
  return answers.groups.front().group.drawn ? spread_answer(answers, units) : range_answer(answers, units);
}

}  // namespace dashpad::output
