#pragma once
/// The answer of a study in a sentence.

#include <cstddef>
#include <cstdint>
#include <string>

#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"

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

}  // namespace dashpad::output
