#include "output/text/study_answer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "output/text/capitals.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

/// A level of a factor, and whether the limit is exceeded there.
using LevelRow = std::pair<double, bool>;

/// The index of the only row, by levels, at which exceeding starts or ends; none without a single one.
std::optional<std::size_t> only_change(const std::vector<LevelRow>& rows) {
  std::optional<std::size_t> change;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].second == rows[i - 1].second) continue;
    if (change) return std::nullopt;
    change = i;
  }
  return change;
}

/// The names with which the limit is exceeded, or those with which it is not if they are fewer.
std::string by_name(const study::StudyAnswers& answers, const std::vector<LevelRow>& rows,
                    const study::StudyLimit& limit, const UnitSystem& units) {
  std::string above, below;
  for (const auto& [level, is_above] : rows) {
    std::string& names = is_above ? above : below;
    names += (names.empty() ? "" : ", ") + level_text(answers.study, 0, level, units);
  }
  if (above.empty() || below.empty()) return "";
  const auto count_above = std::ranges::count_if(rows, &LevelRow::second);
  const std::string exceeded = capitalised(exceeds(limit, units));
  return 2 * count_above > std::ssize(rows) ? fmt::format("{} with all but {}", exceeded, below)
                                            : fmt::format("{} with {}", exceeded, above);
}

std::string over_one(const study::StudyAnswers& answers, const std::vector<LevelRow>& rows,
                     const study::StudyLimit& limit, const UnitSystem& units) {
  const std::optional<std::size_t> change = only_change(rows);
  if (!change) return "";
  const std::string before = level_text(answers.study, 0, rows[*change - 1].first, units),
                    after = level_text(answers.study, 0, rows[*change].first, units),
                    name = factor_words(answers.study.factors.front().key),
                    limited = capitalised(exceeds(limit, units));
  return rows[*change].second
             ? fmt::format("{} if the {} is {} or more, but not at {} or less", limited, name, after, before)
             : fmt::format("{} if the {} is {} or less, but not at {} or more", limited, name, before, after);
}

/// "4.5 m/s": the name only where the unit does not tell it from the other factor.
std::string level_words(const study::Study& study, std::size_t factor, double level,
                        const UnitSystem& units) {
  return study.factors[0].unit == study.factors[1].unit ? factor_at(study, factor, level, units)
                                                        : level_text(study, factor, level, units);
}

/// The range of a factor within which the limit is kept: "up to somewhere between 4.5 m/s and 5 m/s". Empty
/// if it does not reach one end.
std::string where_kept(const study::Study& study, std::size_t factor, const std::vector<LevelRow>& rows,
                       const UnitSystem& units) {
  if (std::ranges::none_of(rows, &LevelRow::second)) return "everywhere";
  if (std::ranges::all_of(rows, &LevelRow::second)) return "nowhere";
  const std::optional<std::size_t> change = only_change(rows);
  if (!change) return "";
  const std::string before = level_words(study, factor, rows[*change - 1].first, units),
                    after = level_words(study, factor, rows[*change].first, units);
  return rows[*change].second ? fmt::format("up to somewhere between {} and {}", before, after)
                              : fmt::format("from somewhere between {} and {} upwards", before, after);
}

using Lines = std::map<double, std::vector<LevelRow>>;

/// The line on which the limit is kept in more rows than at both ends, of several the first; the end of the
/// map if there is none, or if its range is not a single one. Rows by level.
Lines::const_iterator widest_between_ends(const Lines& lines) {
  const auto kept = [](const Lines::value_type& line) {
    return std::ranges::count(line.second, false, &LevelRow::second);
  };
  const auto best = std::ranges::max_element(lines, {}, kept);
  const bool is_better = kept(*best) > std::max(kept(*lines.begin()), kept(*lines.rbegin()));
  const bool is_whole = kept(*best) == std::ssize(best->second) || only_change(best->second);
  return is_better && is_whole ? best : lines.end();
}

/// The ranges along the factor with more levels, at the first and the last level of the other one.
std::string over_two(const study::StudyAnswers& answers, const std::vector<bool>& is_above,
                     const study::StudyLimit& limit, const UnitSystem& units) {
  const study::Group& group = answers.groups.front().group;
  const std::vector<study::Factor>& factors = answers.study.factors;
  if (factors[0].unit.empty() || factors[1].unit.empty()) return "";
  const auto level = [&](std::size_t factor, std::size_t row) {
    return answers.records.factors[factor][group.places[row]];
  };
  Lines lines[2];  // by factor: its levels, the rows along the other one
  for (std::size_t row = 0; row < is_above.size(); ++row)
    for (std::size_t given = 0; given < 2; ++given)
      lines[given][level(given, row)].emplace_back(level(1 - given, row), is_above[row]);
  const std::size_t of = lines[0].size() < lines[1].size() ? 0 : 1;
  for (auto& line : lines[of]) std::ranges::sort(line.second);
  std::string text;
  for (const auto* line : {&*lines[of].begin(), &*lines[of].rbegin()}) {
    const std::string kept = where_kept(answers.study, 1 - of, line->second, units);
    if (kept.empty()) return "";
    text += fmt::format("{} {} at {}", text.empty() ? "" : ", and", kept,
                        level_words(answers.study, of, line->first, units));
  }
  if (const auto best = widest_between_ends(lines[of]); best != lines[of].end())
    text += fmt::format("; best at {}, {}", level_words(answers.study, of, best->first, units),
                        where_kept(answers.study, 1 - of, best->second, units));
  return fmt::format("{} stays within the limit of {}{}", title_of(limit.response),
                     brief_quantity(limit.value, si_unit_of(limit.response), units), text);
}

}  // namespace

std::string exceeds(const study::StudyLimit& limit, const UnitSystem& units) {
  return fmt::format("{} exceeds {}", uncapitalised(title_of(limit.response)),
                     brief_quantity(limit.value, si_unit_of(limit.response), units));
}

std::string where_exceeded(const study::StudyAnswers& answers, const study::StudyLimit& limit,
                           const UnitSystem& units) {
  const study::Group& group = answers.groups.front().group;
  const std::size_t factors = answers.study.factors.size();
  const auto response =
      std::ranges::find(answers.study.responses, limit.response) - answers.study.responses.begin();
  const std::vector<double> values =
      study::values_of(answers.study, answers.records, group, static_cast<std::size_t>(response));
  if (factors == 0 || factors > 2 || (factors == 2 && study::table_rows(answers.study) > 1) ||
      std::ranges::any_of(values, [](double value) { return std::isnan(value); }))
    return "";
  std::vector<bool> is_above;
  for (const double value : values) is_above.push_back(value > limit.value);
  if (factors == 2) return over_two(answers, is_above, limit, units);
  std::vector<LevelRow> rows;
  for (std::size_t i = 0; i < values.size(); ++i)
    rows.emplace_back(answers.records.factors.front()[group.places[i]], is_above[i]);
  std::ranges::sort(rows);
  return answers.study.factors.front().unit.empty() ? by_name(answers, rows, limit, units)
                                                    : over_one(answers, rows, limit, units);
}

}  // namespace dashpad::output
