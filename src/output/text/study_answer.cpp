#include "output/text/study_answer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "output/text/capitals.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

std::string share_of_draws(const study::StudyAnswers::OfGroup& group, std::size_t limit) {
  const study::Estimate& estimate = group.exceedances[limit].probability;
  return std::isfinite(estimate.value) ? fmt::format("in {} of the draws", per_cent(estimate.value))
                                       : "undecided";
}

/// The combinations of levels with the least and the greatest of a value; null where none has one.
template <class ValueOf>
ExtremeGroups extreme_groups(const study::StudyAnswers& answers, const ValueOf& value_of) {
  ExtremeGroups extremes;
  for (const study::StudyAnswers::OfGroup& group : answers.groups) {
    const double value = value_of(group);
    if (std::isnan(value)) continue;
    if (extremes.least == nullptr || value < value_of(*extremes.least)) extremes.least = &group;
    if (extremes.greatest == nullptr || value >= value_of(*extremes.greatest)) extremes.greatest = &group;
  }
  return extremes;
}

/// The combinations of levels at which draws exceed the limit least and most often.
std::string best_and_worst(const study::StudyAnswers& answers, std::size_t limit, const UnitSystem& units) {
  const auto probability = [&](const study::StudyAnswers::OfGroup& group) {
    return group.exceedances[limit].probability.value;
  };
  const auto [best, worst] = extreme_groups(answers, probability);
  if (best == nullptr) return fmt::format("Whether {} is undecided", exceeds(answers.limits[limit], units));
  if (probability(*best) == probability(*worst))
    return fmt::format("{} {} at all {} combinations", capitalised(exceeds(answers.limits[limit], units)),
                       share_of_draws(*best, limit),
                       std::ranges::count_if(answers.groups, [&](const study::StudyAnswers::OfGroup& group) {
                         return !std::isnan(probability(group));
                       }));
  return fmt::format("{} {} at {}, and {} at {}", capitalised(exceeds(answers.limits[limit], units)),
                     share_of_draws(*best, limit), words_of_levels(answers, best->group, units),
                     share_of_draws(*worst, limit), words_of_levels(answers, worst->group, units));
}

/// "all limits are kept in 93.1 % of the draws".
std::string kept_words(const study::StudyAnswers::OfGroup& group) {
  const double exceeding = group.any->probability.value;
  return std::isfinite(exceeding) ? fmt::format("in {} of the draws", per_cent(1 - exceeding)) : "undecided";
}

/// The answer about all limits together, over draws.
std::string all_limits_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  if (answers.groups.size() == 1) {
    const study::Estimate& any = answers.groups.front().any->probability;
    if (!std::isfinite(any.value)) return "Whether all limits are kept is undecided";
    return fmt::format("All limits are kept in {} of the draws (95 % interval {} to {})",
                       per_cent(1 - any.value), per_cent(1 - any.high), per_cent(1 - any.low));
  }
  const auto [best, worst] = extreme_groups(
      answers, [](const study::StudyAnswers::OfGroup& group) { return group.any->probability.value; });
  if (best == nullptr) return "Whether all limits are kept is undecided";
  return fmt::format("All limits are kept {} at {}, and {} at {}", kept_words(*best),
                     words_of_levels(answers, best->group, units), kept_words(*worst),
                     words_of_levels(answers, worst->group, units));
}

/// "; 95 % of the draws stay within the limit from a thickness of the pad of 34.2 mm upwards", of several
/// lines the best.
std::string turns_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  if (answers.turns.empty()) return "";
  // Of thicknesses from which limits are kept the least is best, of heights up to which they are the
  // greatest.
  const study::TurningLevel& best =
      answers.turns.front().kept_above ? answers.turns.front() : answers.turns.back();
  const std::string name = factor_words(answers.study.factors[best.factor].key);
  const std::string limits = answers.limits.size() > 1 ? "all limits" : "the limit";
  if (!std::isfinite(best.level.value))
    return fmt::format("; at no {} of the study do {} of the draws stay within {}", name,
                       per_cent(study::turning_probability), limits);
  const std::string at = levels_beside(answers, best, units);
  return fmt::format("; {} of the draws stay within {} at a {} {}{}", per_cent(study::turning_probability),
                     limits, name, turning_text(answers, best, units),
                     at.empty() ? "" : ", at best, with " + at);
}

/// The answer about all limits together or, over a grid, the one that is exceeded most often.
std::string limit_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  if (answers.groups.front().any && answers.groups.front().group.drawn)
    return all_limits_answer(answers, units);
  const std::size_t number = strictest_limit(answers);
  const study::StudyLimit& limit = answers.limits[number];
  const std::string exceeded = exceeds(limit, units);
  const bool drawn = answers.groups.front().group.drawn;
  if (drawn && answers.groups.size() > 1) return best_and_worst(answers, number, units);
  if (drawn) {
    const study::Exceedance& of = answers.groups.front().exceedances[number];
    const study::Estimate& estimate = of.probability;
    if (!std::isfinite(estimate.value)) return fmt::format("Whether {} is undecided", exceeded);
    if (of.undecided == 0 && of.exceeding == of.rows)
      return fmt::format("{} in all {} draws (probability at least {})", capitalised(exceeded), of.rows,
                         per_cent(estimate.low));
    if (of.undecided == 0 && of.exceeding == 0)
      return fmt::format("{} in none of the {} draws (probability at most {})", capitalised(exceeded),
                         of.rows, per_cent(estimate.high));
    return fmt::format("{} in {} of the draws (95 % interval {} to {})", capitalised(exceeded),
                       per_cent(estimate.value), per_cent(estimate.low), per_cent(estimate.high));
  }
  const LimitCount count = rows_above(answers, number);
  if (count.undecided == 0)
    if (std::string words = where_exceeded(answers, limit, units); !words.empty()) return words;
  if (count.rows == 0) return fmt::format("Whether {} is undecided", exceeded);
  return fmt::format("{} in {} of {} rows{}", capitalised(exceeded), count.exceeding, count.rows,
                     count.undecided > 0 ? fmt::format("; {} more undecided", count.undecided) : "");
}

/// The answer about the first response with Sobol' indices; empty without any.
std::string index_answer(const study::StudyAnswers& answers) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const auto& of = answers.groups.front().sensitivities[i];
    if (!of || of->indices.empty()) continue;
    const auto most = std::ranges::max_element(
        of->indices, {}, [](const study::Sensitivity::Index& index) { return index.total.value; });
    const std::string name = title_of(response_name(answers, i));
    // Indices of few draws are anything: their intervals tell.
    const bool is_decided = std::ranges::all_of(of->indices, [&](const study::Sensitivity::Index& other) {
      return &other == &*most || !(other.total.high >= most->total.low);
    });
    if (!is_decided || !(most->total.low > 0))
      return fmt::format("The draws do not determine which factor affects {} most; it may be the {}",
                         uncapitalised(name), factor_words(most->factor));
    return fmt::format("{} depends most on the {}, which explains {} of its variance", name,
                       factor_words(most->factor), per_cent(std::min(most->total.value, 1.0)));
  }
  return "";
}

double greatest_finite(const study::StudyAnswers& answers) {
  double greatest = -HUGE_VAL;
  for (const double value : study::values_of(answers.study, answers.records, answers.groups.front().group,
                                             answers.responses.front()))
    if (std::isfinite(value)) greatest = std::max(greatest, value);
  return greatest;
}

/// The range of the first response over a grid.
std::string range_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string& name = response_name(answers, 0);
  const study::Distribution& distribution = answers.groups.front().distributions.front();
  if (distribution.rows == 0) return "";
  if (distribution.struck_through == 0 &&
      three_digits(name, distribution.least, units) == three_digits(name, distribution.greatest, units))
    return fmt::format("{} is {}", title_of(name), three_digits(name, distribution.least, units));
  if (distribution.struck_through > 0)
    return fmt::format("The pad bottoms out in {} of {} rows; in the others, {} is {}",
                       distribution.struck_through, distribution.struck_through + distribution.rows,
                       uncapitalised(title_of(name)),
                       three_digit_range(name, distribution.least, greatest_finite(answers), units));
  return fmt::format("{} ranges from {}", title_of(name),
                     three_digit_range(name, distribution.least, distribution.greatest, units));
}

/// The minima of the cushion curves from the greatest drop height.
std::string cushion_answer(const study::CushionCurves& curves, const UnitSystem& units) {
  const study::CushionCurves::Drop& drop = curves.drops.back();
  std::string minima;
  for (const study::CushionCurve& curve : drop.curves) {
    const std::optional<std::size_t> least = study::min_peak(curve);
    if (!least) continue;
    minima += fmt::format("{}{} on {} (at {})", minima.empty() ? "" : ", ",
                          three_digits("peak_acceleration", curve.peak_deceleration[*least], units),
                          brief_quantity(curve.thickness, "m", units, 3),
                          brief_quantity(curve.static_stress[*least], "Pa", units, 3));
  }
  return minima.empty() ? ""
                        : fmt::format("For a drop height of {}, the lowest peaks are {}",
                                      brief_quantity(drop.height, "m", units, 3), minima);
}

/// The combinations of levels with the least and the greatest median.
std::string medians_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string& name = response_name(answers, 0);
  const auto [least, greatest] = extreme_medians(answers, 0);
  if (least == nullptr) return "";
  const auto part = [&](const study::StudyAnswers::OfGroup& group) {
    return fmt::format("{} at {}",
                       three_digits(name, study::quantile(group.distributions.front(), 0.5)->value, units),
                       words_of_levels(answers, group.group, units));
  };
  return fmt::format("The median {} ranges from {} to {}", uncapitalised(title_of(name)), part(*least),
                     part(*greatest));
}

std::string spread_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  const std::string& name = response_name(answers, 0);
  const study::Distribution& distribution = answers.groups.front().distributions.front();
  std::vector<std::string> parts;
  for (const auto& [probability, words] : {std::pair{0.5, "half of the draws are"}, {0.95, "95 %"}})
    if (const auto found = study::quantile(distribution, probability); found && !std::isinf(found->value))
      parts.push_back(fmt::format("{} below {}", words, three_digits(name, found->value, units)));
  if (distribution.rows == 0 && distribution.struck_through == 0) return "";
  const std::string of_values = fmt::format("{}: {}", title_of(name), fmt::join(parts, ", "));
  if (distribution.struck_through == 0) return of_values;
  const auto struck = static_cast<double>(distribution.struck_through);
  return fmt::format("The pad bottoms out in {} of the draws{}",
                     per_cent(struck / (struck + static_cast<double>(distribution.rows))),
                     parts.empty() ? "" : "; " + uncapitalised(of_values));
}

}  // namespace

ExtremeGroups extreme_medians(const study::StudyAnswers& answers, std::size_t response) {
  return extreme_groups(answers, [&](const study::StudyAnswers::OfGroup& group) {
    const auto median = study::quantile(group.distributions[response], 0.5);
    return median ? median->value : NAN;
  });
}

LimitCount rows_above(const study::StudyAnswers& answers, std::size_t limit) {
  LimitCount count;
  for (const study::StudyAnswers::OfGroup& group : answers.groups) {
    count.exceeding += group.exceedances[limit].exceeding;
    count.rows += group.exceedances[limit].rows;
    count.undecided += group.exceedances[limit].undecided;
  }
  return count;
}

std::size_t strictest_limit(const study::StudyAnswers& answers) {
  std::size_t strictest = 0;
  for (std::size_t i = 1; i < answers.limits.size(); ++i)
    if (rows_above(answers, i).exceeding > rows_above(answers, strictest).exceeding) strictest = i;
  return strictest;
}

std::string study_answer(const study::StudyAnswers& answers, const UnitSystem& units) {
  if (answers.groups.empty() || answers.responses.empty() || answers.records.rows.empty()) return "";
  if (const std::uint64_t rows = answers.records.rows.size(); answers.records.struck_through == rows)
    return rows == 1 ? "The pad bottoms out" : fmt::format("The pad bottoms out in all {} rows", rows);
  if (!answers.limits.empty()) return limit_answer(answers, units) + turns_answer(answers, units);
  if (std::string indices = index_answer(answers); !indices.empty()) return indices;
  if (answers.cushion_curves && !answers.cushion_curves->drops.empty())
    return cushion_answer(*answers.cushion_curves, units);
  if (answers.groups.front().group.drawn && answers.groups.size() > 1) return medians_answer(answers, units);
  return answers.groups.front().group.drawn ? spread_answer(answers, units) : range_answer(answers, units);
}

}  // namespace dashpad::output
