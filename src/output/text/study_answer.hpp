#pragma once
/// The answer of a study in a sentence, its key figures, and all of its answers as tables.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

/// The answer to the first question that the study answers: the probability that the strictest limit is
/// exceeded, or where it is exceeded, or in how many rows; which factor matters most; where a response is
/// least; how the draws scatter. Empty for a study without rows.
std::string study_answer(const study::StudyAnswers& answers, const UnitSystem& units);

/// The figures behind study_answer(): probabilities, the factors that matter, least peaks of cushion curves,
/// or ranges. At most max_key_figures; none without rows.
std::vector<ValueRow> study_key_figures(const study::StudyAnswers& answers, const UnitSystem& units);

/// Combinations of levels; null where none has a value.
struct ExtremeGroups {
  const study::StudyAnswers::OfGroup* least = nullptr;
  const study::StudyAnswers::OfGroup* greatest = nullptr;
};

/// The combinations with the least and the greatest median of a response (index in StudyAnswers::responses).
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

/// Where a limit is exceeded: over one factor, from which level on or with which names; over two, the range
/// within which it is kept at both ends of the factor with fewer levels, and where it is widest between them.
/// Empty for other studies, for undecided rows, and if exceeding starts or ends more than once.
std::string where_exceeded(const study::StudyAnswers& answers, const study::StudyLimit& limit,
                           const UnitSystem& units);

/// The largest number of combinations of levels in the tables; the JSON has all.
inline constexpr std::size_t max_groups_shown = 24;

/// Distributions and, where asked for, exceedances and indices, over all combinations of levels.
std::vector<Table> study_tables(const study::StudyAnswers& answers, const UnitSystem& units);

/// The factors and how they vary.
Table factor_table(const study::StudyAnswers& answers, const UnitSystem& units);

/// The warnings of a study, a sentence each, beginning with words in capitals.
std::vector<std::string> study_warnings(const study::StudyAnswers& answers);

/// The meaning of the intervals.
std::string interval_note(const study::StudyAnswers& answers);

}  // namespace dashpad::output
