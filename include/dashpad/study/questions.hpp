#pragma once
/// What is asked of a study, and all answers to it.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/study/answers.hpp"
#include "dashpad/study/cushion_curves.hpp"

namespace dashpad {

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
  study::Study study;
  std::string program;     ///< that computed the rows
  std::uint64_t rows = 0;  ///< of the whole study
  study::Records records;
  std::vector<std::size_t> responses;  ///< asked for: numbers in Study::responses
  std::vector<StudyLimit> limits;

  /// Of one combination of levels.
  struct OfGroup {
    study::Group group;
    std::vector<study::Distribution> distributions;                ///< of each response asked for
    std::vector<study::Exceedance> exceedances;                    ///< of each limit
    std::vector<std::optional<study::Sensitivity>> sensitivities;  ///< of each response asked for
  };
  std::vector<OfGroup> groups;
  std::optional<study::CushionCurves> cushion_curves;
};

/// Throws std::invalid_argument for names that the study does not keep.
StudyAnswers study_answers(const study::Store& store, const StudyQuestions& questions);

}  // namespace dashpad
