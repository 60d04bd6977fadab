#pragma once
/// The answer of a study in a sentence, and all of its answers as tables.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

/// Of the first question that the study answers: how probable it is that the strictest limit is exceeded,
/// from where on, or in how many rows; which factor matters most; where a response is least; how its draws
/// spread. Empty for a study without rows.
std::string study_answer(const study::StudyAnswers& answers, const UnitSystem& units);

/// Combinations of levels; null where none has a value.
struct ExtremeGroups {
  const study::StudyAnswers::OfGroup* least = nullptr;
  const study::StudyAnswers::OfGroup* greatest = nullptr;
};

/// Of draws, those with the least and the greatest median of a response, which counts in
/// StudyAnswers::responses.
ExtremeGroups extreme_medians(const study::StudyAnswers& answers, std::size_t response);

/// Rows of all groups, by one of the limits of the study.
struct LimitCount {
  std::uint64_t exceeding = 0, rows = 0, undecided = 0;
};
LimitCount rows_above(const study::StudyAnswers& answers, std::size_t limit);

/// Which limit is exceeded in the most rows; the study has one.
std::size_t strictest_limit(const study::StudyAnswers& answers);

/// "HIC15 exceeds 1000"
std::string exceeds(const study::StudyLimit& limit, const UnitSystem& units);

/// Over one factor, from where on the limit is exceeded, or with which of its names; over two, up to where it
/// is kept at the ends of the second. Empty where that is no sentence: with other factors, undecided rows,
/// and where it changes more than once or not at all.
std::string where_exceeded(const study::StudyAnswers& answers, const study::StudyLimit& limit,
                           const UnitSystem& units);

/// More combinations of levels are only in the JSON.
inline constexpr std::size_t max_groups_shown = 24;

/// Distributions and, where asked for, exceedances and indices, over all combinations of levels.
std::vector<Table> study_tables(const study::StudyAnswers& answers, const UnitSystem& units);

/// What was studied: factors and how they vary.
Table factor_table(const study::StudyAnswers& answers, const UnitSystem& units);

/// What to beware of, a sentence each; its first words in capitals.
std::vector<std::string> study_warnings(const study::StudyAnswers& answers);

/// What the intervals mean.
std::string interval_note(const study::StudyAnswers& answers);

}  // namespace dashpad::output
