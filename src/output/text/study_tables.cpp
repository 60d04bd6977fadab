#include "output/text/study_answer.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/study/responses.hpp"
#include "output/layout.hpp"
#include "output/text/capitals.hpp"
#include "output/text/study_words.hpp"
#include "uncertainty/foam_factors.hpp"

namespace dashpad::output {

namespace {

using Row = std::vector<std::string>;

constexpr double shown_quantiles[] = {0.05, 0.5, 0.95};
/// The only quantile of a grid that is shown: the others depend on the choice of its levels.
constexpr double median = 0.5;

/// The number of rows that bottomed out, "229 (22.9 %)"; "-" for responses that stay finite then.
std::string struck_through(const std::string& response, std::uint64_t count, std::uint64_t rows) {
  const ResultQuantity* kind = study::find_response_kind(response);
  if (kind == nullptr || kind->role.growth != Growth::with_force) return "-";
  return fmt::format("{} ({} %)", count,
                     four_digits(100 * static_cast<double>(count) / static_cast<double>(rows)));
}

std::string share_above(const study::Exceedance& exceedance) {
  if (exceedance.rows > 0) return percent_with_interval(exceedance.probability);
  return fmt::format("undecided ({} to {})", four_digits(100 * exceedance.probability.low),
                     four_digits(100 * exceedance.probability.high));
}

void add_distributions(Table& table, const study::StudyAnswers& answers,
                       const study::StudyAnswers::OfGroup& group, const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::string name = response_name(answers, i);
    const study::Distribution& distribution = group.distributions[i];
    const ScaledUnit shown = shown_as(si_unit_of(name), units);
    const auto digits = [&](double value) { return four_digits_or_struck(shown.scale * value); };
    Row row{label(name, units)};
    if (group.group.drawn)
      row.insert(row.end(), {with_interval(distribution.mean, shown.scale), digits(distribution.deviation)});
    for (const study::Distribution::Quantile& quantile : distribution.quantiles)
      if (group.group.drawn
              ? std::ranges::find(shown_quantiles, quantile.probability) != std::end(shown_quantiles)
              : quantile.probability == median)
        row.push_back(with_interval(quantile.value, shown.scale));
    row.push_back(digits(distribution.least));
    row.push_back(digits(distribution.greatest));
    if (answers.records.struck_through > 0)
      row.push_back(struck_through(name, distribution.struck_through,
                                   distribution.rows + distribution.struck_through + distribution.without));
    row.push_back(distribution.without == 0
                      ? std::to_string(distribution.rows)
                      : fmt::format("{} ({} without a value)", distribution.rows, distribution.without));
    table.rows.push_back(std::move(row));
  }
}

void add_exceedances(Table& table, const study::StudyAnswers& answers,
                     const study::StudyAnswers::OfGroup& group, const UnitSystem& units) {
  for (std::size_t i = 0; i < answers.limits.size(); ++i) {
    const study::StudyLimit& limit = answers.limits[i];
    const study::Exceedance& exceedance = group.exceedances[i];
    const ScaledUnit shown = shown_as(si_unit_of(limit.response), units);
    Row row{title_of(limit.response), with_unit(four_digits(shown.scale * limit.value), shown.unit),
            share_above(exceedance), std::to_string(exceedance.exceeding)};
    if (answers.records.struck_through > 0)
      row.push_back(
          struck_through(limit.response, exceedance.struck_through, exceedance.rows + exceedance.undecided));
    row.push_back(exceedance.undecided == 0
                      ? std::to_string(exceedance.rows)
                      : fmt::format("{} ({} undecided)", exceedance.rows, exceedance.undecided));
    table.rows.push_back(std::move(row));
  }
  if (!group.any) return;
  Row row{"One limit or more", "", share_above(*group.any), std::to_string(group.any->exceeding)};
  if (answers.records.struck_through > 0) row.push_back(std::to_string(group.any->struck_through));
  row.push_back(group.any->undecided == 0
                    ? std::to_string(group.any->rows)
                    : fmt::format("{} ({} undecided)", group.any->rows, group.any->undecided));
  table.rows.push_back(std::move(row));
}

void add_indices(Table& table, const study::StudyAnswers& answers, const study::StudyAnswers::OfGroup& group,
                 const UnitSystem& /*none of them has a unit*/) {
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    if (!group.sensitivities[i]) continue;
    for (const study::Sensitivity::Index& index : group.sensitivities[i]->indices)
      table.rows.push_back({title_of(response_name(answers, i)), factor_title(index.factor),
                            share_with_interval(index.first), share_with_interval(index.total),
                            std::to_string(group.sensitivities[i]->draws)});
  }
}

/// The combinations by a response, the least first, each compared with it over the same draws.
Table ranking_table(const study::StudyAnswers& answers, std::size_t response, const UnitSystem& units) {
  const std::string& name = response_name(answers, response);
  const ScaledUnit shown = shown_as(si_unit_of(name), units);
  Table table{.caption = "Ranking by " + uncapitalised(label(name, units)) + ", over the same draws",
              .columns = {"At", "Median", "Mean difference to the first", "Higher than the first (%)"}};
  for (const study::Ranked& ranked : answers.rankings[response]) {
    if (table.rows.size() == max_groups_shown) break;
    const bool is_first = table.rows.empty();
    table.rows.push_back({words_of_levels(answers, answers.groups[ranked.group].group, units),
                          four_digits_or_struck(shown.scale * ranked.median),
                          is_first ? "-"
                          : std::isfinite(ranked.difference.value)
                              ? with_interval(ranked.difference, shown.scale)
                              : "-",
                          is_first ? "-" : share_above(ranked.higher)});
  }
  return table;
}

/// Where all limits come to be kept in most draws, for each combination of the other factors.
Table turning_table(const study::StudyAnswers& answers, const UnitSystem& units) {
  const study::TurningLevel& first = answers.turns.front();
  Table table{
      .caption =
          fmt::format("Where {} % of the draws stay within all limits", 100 * study::turning_probability),
      .columns = {"With", capitalised(factor_words(answers.study.factors[first.factor].key)), "Draws"}};
  for (const study::TurningLevel& turn : answers.turns) {
    if (table.rows.size() == max_groups_shown) break;
    const std::string beside = levels_beside(answers, turn, units);
    table.rows.push_back(
        {beside.empty() ? "all" : beside, turning_text(answers, turn, units), std::to_string(turn.draws)});
  }
  return table;
}

/// The columns, and where pads bottomed out on a rigid support a column for them before the last.
Row with_struck_through(const study::StudyAnswers& answers, Row columns) {
  if (answers.records.struck_through > 0) columns.insert(columns.end() - 1, "Bottomed out");
  return columns;
}

using AddRows = void (*)(Table&, const study::StudyAnswers&, const study::StudyAnswers::OfGroup&,
                         const UnitSystem&);

/// The rows of all combinations of levels in one table; where there are several, the first column names them.
Table over_groups(Table table, const study::StudyAnswers& answers, const UnitSystem& units, AddRows add) {
  const bool named = answers.groups.size() > 1;
  if (named) table.columns.insert(table.columns.begin(), "At");
  for (std::size_t i = 0; i < answers.groups.size() && i < max_groups_shown; ++i) {
    const study::StudyAnswers::OfGroup& group = answers.groups[i];
    const std::size_t begin = table.rows.size();
    add(table, answers, group, units);
    for (std::size_t row = begin; named && row < table.rows.size(); ++row)
      table.rows[row].insert(table.rows[row].begin(), words_of_levels(answers, group.group, units));
  }
  return table;
}

std::string spread_text(const study::StudyAnswers& answers, std::size_t factor, const UnitSystem& units) {
  using namespace study;
  const auto text = [&](double value) { return level_text(answers.study, factor, value, units); };
  const Spread& spread = answers.study.factors[factor].spread;
  if (const auto* given = std::get_if<Normal>(&spread))
    return fmt::format("normal, mean {}, standard deviation {}", text(given->mean), text(given->deviation));
  if (const auto* given = std::get_if<Lognormal>(&spread))
    return fmt::format("lognormal, median {}, standard deviation of the logarithm {}", text(given->median),
                       four_digits(given->spread));
  if (const auto* given = std::get_if<Uniform>(&spread))
    return fmt::format("uniform, {} to {}", text(given->low), text(given->high));
  if (const auto* given = std::get_if<Triangular>(&spread))
    return fmt::format("triangular, {} to {}, mode {}", text(given->low), text(given->high),
                       text(given->mode));
  if (const auto* given = std::get_if<Empirical>(&spread))
    return fmt::format("{} measured values, {} to {}", given->values.size(), text(given->values.front()),
                       text(given->values.back()));
  if (const auto* given = std::get_if<ByDraw>(&spread)) {
    const auto [least, greatest] = std::ranges::minmax(given->values);
    return fmt::format("drawn from {}, {} to {}", plural(given->values.size(), "row"), text(least),
                       text(greatest));
  }
  const std::vector<double>& values = *answers.study.factors[factor].given_values();
  std::string list = plural(values.size(), std::holds_alternative<ByRow>(spread) ? "row" : "level") + ": ";
  if (values.size() > 8)
    return list + fmt::format("{}, {} ... {}", text(values[0]), text(values[1]), text(values.back()));
  for (std::size_t i = 0; i < values.size(); ++i) list += (i == 0 ? "" : ", ") + text(values[i]);
  return list;
}

/// The rows of a table of rows, each with its labels, if neither levels nor draws multiply them.
std::optional<Table> row_table(const study::StudyAnswers& answers, const UnitSystem& units) {
  constexpr std::size_t max_rows_shown = 50, max_labels = 2, max_responses = 5;
  const study::Study& study = answers.study;
  const std::size_t rows = study::table_rows(study);
  if (rows < 2 || answers.rows != rows) return std::nullopt;
  const study::Group& all = answers.groups.front().group;
  const std::size_t shown = std::min(all.places.size(), max_rows_shown);
  const std::size_t computed = all.places.size();
  Table table{
      .caption = shown < computed ? fmt::format("Rows (the first {} of {})", shown, computed) : "Rows",
      .columns = {"Row"}};
  for (std::size_t k = 0; k < shown; ++k)
    table.rows.push_back({std::to_string(answers.records.rows[all.places[k]])});
  for (std::size_t i = 0; i < std::min(study.labels.size(), max_labels); ++i) {
    table.columns.push_back(one_line(study.labels[i].name));
    for (std::size_t k = 0; k < shown; ++k)
      table.rows[k].push_back(one_line(study.labels[i].texts[answers.records.rows[all.places[k]]]));
  }
  for (std::size_t i = 0; i < std::min(answers.responses.size(), max_responses); ++i) {
    const std::string& name = response_name(answers, i);
    const double scale = shown_as(si_unit_of(name), units).scale;
    const std::vector<double> values = study::values_of(study, answers.records, all, answers.responses[i]);
    table.columns.push_back(label(name, units));
    for (std::size_t k = 0; k < shown; ++k) table.rows[k].push_back(four_digits_or_struck(scale * values[k]));
  }
  return table;
}

}  // namespace

std::vector<Table> study_tables(const study::StudyAnswers& answers, const UnitSystem& units) {
  const bool drawn = answers.groups.front().group.drawn;
  const Row columns =
      drawn ? Row{"Response", "Mean", "Deviation", "5 %", "Median", "95 %", "Least", "Greatest", "Rows"}
            : Row{"Response", "Median", "Least", "Greatest", "Rows"};
  std::vector<Table> tables{over_groups({.caption = drawn                                  ? "Distribution"
                                                    : study::table_rows(answers.study) > 1 ? "Over the rows"
                                                                                           : "Over the grid",
                                         .columns = with_struck_through(answers, columns)},
                                        answers, units, add_distributions)};
  if (std::optional<Table> rows = row_table(answers, units)) tables.push_back(*std::move(rows));
  if (!answers.limits.empty())
    tables.push_back(over_groups(
        {.caption = drawn ? "Probability of exceeding a limit" : "Share of rows above a limit",
         .columns = with_struck_through(
             answers, {"Response", "Limit", drawn ? "Probability (%)" : "Share (%)", "Rows above", "Rows"})},
        answers, units, add_exceedances));
  if (!answers.turns.empty()) tables.push_back(turning_table(answers, units));
  // Of what is limited, or of the first response: each would be a table.
  for (std::size_t i = 0; i < answers.rankings.size(); ++i) {
    const bool is_limited = std::ranges::find(answers.limits, response_name(answers, i),
                                              &study::StudyLimit::response) != answers.limits.end();
    if (!answers.rankings[i].empty() && (is_limited || (answers.limits.empty() && i == 0)))
      tables.push_back(ranking_table(answers, i, units));
  }
  if (answers.study.indices)
    tables.push_back(
        over_groups({.caption = "Sobol' indices: share of the variance that each factor explains",
                     .columns = {"Response", "Factor", "First order", "Total (with interactions)", "Draws"}},
                    answers, units, add_indices));
  return tables;
}

Table factor_table(const study::StudyAnswers& answers, const UnitSystem& units) {
  Table table{.caption = "Factors", .columns = {"Factor", "Variation"}};
  for (std::size_t i = 0; i < answers.study.factors.size(); ++i) {
    const study::Factor& factor = answers.study.factors[i];
    std::string text = spread_text(answers, i, units);
    if (factor.lowest) text += ", not below " + level_text(answers.study, i, *factor.lowest, units);
    if (factor.highest) text += ", not above " + level_text(answers.study, i, *factor.highest, units);
    table.rows.push_back({factor_title(factor.key), text});
  }
  return table;
}

std::vector<std::string> study_warnings(const study::StudyAnswers& answers) {
  std::vector<std::string> texts;
  const study::Records& records = answers.records;
  const std::size_t rows = records.rows.size();
  const auto add = [&](std::uint64_t count, const char* name, const char* words) {
    if (count > 0) texts.push_back(fmt::format("{} {} of {} rows {}", name, count, rows, words));
  };
  if (rows < answers.rows)
    texts.push_back(
        fmt::format("NOT COMPLETE: {} of {} rows have been computed, in batch order. Run the same command "
                    "again to resume.",
                    rows, answers.rows));
  add(records.doubtful, "DOUBTFUL: in",
      "the tolerance is missed, the case is invalid or a requested figure is missing. These rows are not "
      "used to decide any limit.");
  if (records.struck_through > 0)
    texts.push_back(fmt::format(
        "BOTTOMED OUT: in {} of {} rows ({} %) the pad bottomed out on its rigid support, where the force "
        "has no bound. In these rows, force, acceleration, clips, HIC and severity index are treated as "
        "above every limit and, in the quantiles, as above all other rows; these responses have no mean.",
        records.struck_through, rows,
        four_digits(100 * static_cast<double>(records.struck_through) / static_cast<double>(rows))));
  if (records.bottomed > records.struck_through)
    add(records.bottomed - records.struck_through, "BOTTOMED: in",
        "the pad was fully compressed and only the support gave way; the figures of these rows are used as "
        "computed.");
  add(records.time_limit, "TIME LIMIT: in",
      "the impactor was still on the pad when the time limit was reached. In these rows, the largest "
      "values are lower bounds, so a limit that they do not exceed is undecided.");
  add(records.beyond_strain, "EXTRAPOLATED STRAIN: in",
      "the strain goes beyond the tested range, where the stress is a guess.");
  add(records.beyond_rate, "EXTRAPOLATED RATE: in",
      "the strain rate goes beyond the tested range, where the stress follows an assumed law.");
  if (records.beyond_strain + records.beyond_rate == 0)
    add(records.extrapolated, "EXTRAPOLATED: in", "the material goes beyond its tested range.");
  if (answers.groups.size() > max_groups_shown)
    texts.push_back(
        fmt::format("CUT: only the first {} of {} combinations of levels are shown; --json has all.",
                    max_groups_shown, answers.groups.size()));
  for (const std::string& text : by_severity(answers.reservations)) texts.push_back(text);
  return texts;
}

namespace {

/// Factors correlated with an earlier one: the Cholesky factor moves their draws out of their strata.
std::string unstratified_factors(const study::Study& study) {
  std::vector<bool> is_later(study.factors.size());
  for (const study::Correlation& pair : study.correlations)
    if (pair.value != 0) is_later[std::max(pair.first, pair.second)] = true;
  std::string names;
  for (std::size_t i = 0; i < is_later.size(); ++i)
    if (is_later[i]) names += (names.empty() ? "" : ", ") + factor_words(study.factors[i].key);
  return names;
}

}  // namespace

std::string interval_note(const study::StudyAnswers& answers) {
  if (!answers.groups.front().group.drawn)
    return "A grid gives no probabilities: the figures are taken over all its rows, with equal weight for "
           "each, and have no intervals. A range in brackets is due to undecided rows.";
  std::string note =
      "In brackets: 95 % intervals, from Student's t for means, from order statistics for quantiles, and "
      "from Clopper and Pearson's method for probabilities. They cover the sampling error only.";
  if (answers.study.sampling != study::Sampling::monte_carlo)
    note +=
        " They assume independent draws; the draws of this study are more evenly spread, so the intervals "
        "are too wide rather than too narrow.";
  if (std::ranges::any_of(answers.study.factors, [](const study::Factor& factor) {
        return uncertainty::is_foam_factor(factor.key) &&
               std::holds_alternative<study::Uniform>(factor.spread);
      }))
    note +=
        " The foam is drawn as well: all values within the ranges that its tests leave open are assumed to "
        "be "
        "equally likely.";
  const std::string names = unstratified_factors(answers.study);
  if (answers.study.sampling == study::Sampling::latin_hypercube && !names.empty())
    note += fmt::format(
        " Not stratified: {}. Of two correlated factors, only the first keeps one draw per stratum of the "
        "Latin hypercube.",
        names);
  return note;
}

}  // namespace dashpad::output
