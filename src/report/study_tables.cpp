#include "report/study_tables.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/text.hpp"
#include "report/study_words.hpp"

namespace dashpad {

namespace {

using Row = std::vector<std::string>;

constexpr double shown_quantiles[] = {0.05, 0.5, 0.95};

std::string name_of(const StudyAnswers& answers, std::size_t response) {
  return answers.study.responses[response];
}

void add_distributions(PageTable& table, const StudyAnswers& answers, const StudyAnswers::OfGroup& of,
                       const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::string name = name_of(answers, answers.responses[i]);
    const study::Distribution& distribution = of.distributions[i];
    const ShownUnit shown = shown_as(si_unit_of(name), units);
    const auto digits = [&](double value) { return four_digits(shown.scale * value); };
    Row row{label(name, si_unit_of(name), units), with_interval(distribution.mean, shown.scale),
            digits(distribution.deviation)};
    for (const study::Distribution::Quantile& quantile : distribution.quantiles)
      if (std::ranges::find(shown_quantiles, quantile.probability) != std::end(shown_quantiles))
        row.push_back(with_interval(quantile.value, shown.scale));
    row.push_back(digits(distribution.least));
    row.push_back(digits(distribution.greatest));
    row.push_back(distribution.without == 0
                      ? std::to_string(distribution.rows)
                      : fmt::format("{} ({} without)", distribution.rows, distribution.without));
    table.rows.push_back(std::move(row));
  }
}

void add_exceedances(PageTable& table, const StudyAnswers& answers, const StudyAnswers::OfGroup& of,
                     const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.limits.size(); ++i) {
    const StudyLimit& limit = answers.limits[i];
    const study::Exceedance& exceedance = of.exceedances[i];
    const ShownUnit shown = shown_as(si_unit_of(limit.response), units);
    table.rows.push_back(
        {limit.response,
         four_digits(shown.scale * limit.value) + (shown.unit.empty() ? "" : " " + shown.unit),
         percent_with_interval(exceedance.probability), std::to_string(exceedance.exceeding),
         exceedance.without == 0 ? std::to_string(exceedance.rows)
                                 : fmt::format("{} ({} without)", exceedance.rows, exceedance.without)});
  }
}

void add_indices(PageTable& table, const StudyAnswers& answers, const StudyAnswers::OfGroup& of,
                 const UnitSystem& /*none of them has a unit*/) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    if (!of.sensitivities[i]) continue;
    for (const study::Sensitivity::Index& index : of.sensitivities[i]->indices)
      table.rows.push_back({name_of(answers, answers.responses[i]), index.factor,
                            share_with_interval(index.first), share_with_interval(index.total),
                            std::to_string(of.sensitivities[i]->draws)});
  }
}

using AddRows = void (*)(PageTable&, const StudyAnswers&, const StudyAnswers::OfGroup&, const UnitSystem&);

/// The rows of all combinations of levels in one table; where there are several, the first column names them.
PageTable over_groups(PageTable table, const StudyAnswers& answers, const UnitSystem& units, AddRows add) {
  const bool named = answers.groups.size() > 1;
  if (named) table.columns.insert(table.columns.begin(), "At");
  for (std::size_t i = 0; i < answers.groups.size() && i < most_groups_shown; ++i) {
    const StudyAnswers::OfGroup& of = answers.groups[i];
    const std::size_t begin = table.rows.size();
    add(table, answers, of, units);
    for (std::size_t row = begin; named && row < table.rows.size(); ++row)
      table.rows[row].insert(table.rows[row].begin(), group_label(answers, of.group, units));
  }
  return table;
}

std::string spread_text(const StudyAnswers& answers, std::size_t factor, const UnitSystem& units) {
  using namespace study;
  const auto text = [&](double value) { return level_text(answers.study, factor, value, units); };
  const Spread& spread = answers.study.factors[factor].spread;
  if (const auto* of = std::get_if<Normal>(&spread))
    return fmt::format("normal, mean {}, deviation {}", text(of->mean), text(of->deviation));
  if (const auto* of = std::get_if<Lognormal>(&spread))
    return fmt::format("lognormal, median {}, spread of the logarithm {}", text(of->median),
                       four_digits(of->spread));
  if (const auto* of = std::get_if<Uniform>(&spread))
    return fmt::format("uniform, {} to {}", text(of->low), text(of->high));
  if (const auto* of = std::get_if<Triangular>(&spread))
    return fmt::format("triangular, {}, {}, {}", text(of->low), text(of->mode), text(of->high));
  if (const auto* of = std::get_if<Empirical>(&spread))
    return fmt::format("{} measured values, {} to {}", of->values.size(), text(of->values.front()),
                       text(of->values.back()));
  const std::vector<double>& values = std::get<Levels>(spread).values;
  std::string list = fmt::format("{} levels: ", values.size());
  if (values.size() > 8)
    return list + fmt::format("{}, {} ... {}", text(values[0]), text(values[1]), text(values.back()));
  for (std::size_t i = 0; i < values.size(); ++i) list += (i == 0 ? "" : ", ") + text(values[i]);
  return list;
}

}  // namespace

std::vector<PageTable> study_tables(const StudyAnswers& answers, const UnitSystem& units) {
  const bool drawn = answers.groups.front().group.drawn;
  std::vector<PageTable> tables{over_groups(
      {.caption = "Distribution",
       .columns = {"Response", "Mean", "Deviation", "5 %", "Median", "95 %", "Least", "Greatest", "Rows"}},
      answers, units, add_distributions)};
  if (!answers.limits.empty())
    tables.push_back(over_groups(
        {.caption = drawn ? "Probability of more than a limit" : "Share of rows above a limit",
         .columns = {"Response", "Limit", drawn ? "Probability (%)" : "Share (%)", "Rows above", "Rows"}},
        answers, units, add_exceedances));
  if (answers.study.indices)
    tables.push_back(over_groups(
        {.caption = "Sobol' indices: share of the variance that a factor explains",
         .columns = {"Response", "Factor", "Alone (first order)", "With interactions (total)", "Draws"}},
        answers, units, add_indices));
  return tables;
}

PageTable factor_table(const StudyAnswers& answers, const UnitSystem& units) {
  PageTable table{.caption = "Factors", .columns = {"Factor", "Varies"}, .rows = {}};
  for (std::size_t i = 0; i < answers.study.factors.size(); ++i) {
    const study::Factor& factor = answers.study.factors[i];
    std::string text = spread_text(answers, i, units);
    if (factor.lowest) text += ", not below " + level_text(answers.study, i, *factor.lowest, units);
    if (factor.highest) text += ", not above " + level_text(answers.study, i, *factor.highest, units);
    table.rows.push_back({factor.key, text});
  }
  return table;
}

std::vector<std::string> study_warnings(const StudyAnswers& answers) {
  std::vector<std::string> texts;
  const study::Records& records = answers.records;
  const std::size_t rows = records.rows.size();
  if (rows < answers.rows)
    texts.push_back(
        fmt::format("NOT COMPLETE: {} of {} rows are computed, in the order of their batches. The same "
                    "command goes on.",
                    rows, answers.rows));
  if (records.doubtful > 0)
    texts.push_back(fmt::format("DOUBTFUL: {} of {} rows miss the tolerance or make no valid case.",
                                records.doubtful, rows));
  if (records.bottomed > 0)
    texts.push_back(
        fmt::format("BOTTOMED: in {} of {} rows the pad was fully compressed. Rows without a finite "
                    "force count as \"without\"; they are the hardest impacts, so means and quantiles "
                    "of the others are too low.",
                    records.bottomed, rows));
  if (records.extrapolated > 0)
    texts.push_back(fmt::format("EXTRAPOLATED: {} of {} rows go beyond what the material was measured for.",
                                records.extrapolated, rows));
  if (answers.groups.size() > most_groups_shown)
    texts.push_back(fmt::format("CUT: the first {} of {} combinations of levels are shown; --json has all.",
                                most_groups_shown, answers.groups.size()));
  return texts;
}

std::string interval_note(const StudyAnswers& answers) {
  if (!answers.groups.front().group.drawn)
    return "Figures are over the levels as they are, each row counting the same. A grid has no "
           "probabilities, so "
           "there are no intervals.";
  std::string note =
      "In brackets: 95 % intervals, of the mean by Student, of quantiles between order statistics, of "
      "probabilities by Clopper and Pearson. They cover the sampling only.";
  if (answers.study.sampling != study::Sampling::monte_carlo)
    note +=
        " They are made for independent draws; this study's are more even, so they are too wide rather than "
        "too "
        "narrow.";
  return note;
}

}  // namespace dashpad
