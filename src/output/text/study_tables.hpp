#pragma once
/// The answers of a study as tables.

#include <vector>

#include "dashpad/output/text/table.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::output {

/// More combinations of levels are only in the JSON.
inline constexpr std::size_t most_groups_shown = 24;

/// Distributions and, where asked for, exceedances and indices, over all combinations of levels.
std::vector<Table> study_tables(const study::StudyAnswers& answers, const UnitSystem& units);

/// What was studied: factors and how they vary.
Table factor_table(const study::StudyAnswers& answers, const UnitSystem& units);

/// What to beware of, a sentence each; its first words in capitals.
std::vector<std::string> study_warnings(const study::StudyAnswers& answers);

/// What the intervals mean.
std::string interval_note(const study::StudyAnswers& answers);

}  // namespace dashpad::output
