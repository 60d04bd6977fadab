#pragma once
/// What is asked of a study, and all answers to it.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/study/answers.hpp"
#include "dashpad/study/cushion_curves.hpp"

namespace dashpad::study {

/// The probability of more than this is asked for.
struct StudyLimit {
  std::string response;
  double value = 0;  ///< SI
};

struct StudyQuestions {
  std::vector<std::string> responses = {};  ///< names; empty: all that the study keeps
  std::vector<StudyLimit> limits = {};
};

struct StudyAnswers {
  Study study;
  std::string program;     ///< that computed the rows
  std::uint64_t rows = 0;  ///< of the whole study
  Records records;
  std::vector<std::size_t> responses;  ///< asked for: numbers in Study::responses
  std::vector<StudyLimit> limits;

  /// Of one combination of levels.
  struct OfGroup {
    Group group;
    std::vector<Distribution> distributions;                ///< of each response asked for
    std::vector<Exceedance> exceedances;                    ///< of each limit
    std::vector<std::optional<Sensitivity>> sensitivities;  ///< of each response asked for
  };
  std::vector<OfGroup> groups;
  std::optional<CushionCurves> cushion_curves;
};

/// Throws std::invalid_argument for names that the study does not keep.
StudyAnswers study_answers(const Store& store, const StudyQuestions& questions);

}  // namespace dashpad::study
