#pragma once
/// The answers of a study as people and programs read them: text, JSON, a page, a still.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/io/unit_system.hpp"
#include "dashpad/report/figures_page.hpp"
#include "dashpad/report/plot.hpp"
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

/// For the terminal.
std::string study_text(const StudyAnswers& answers, const UnitSystem& units);

/// Everything, in SI; a figure that is absent or not finite is null.
std::string study_json(const StudyAnswers& answers);

/// The page, for figures_page().
FiguresPage study_page(const StudyAnswers& answers, const UnitSystem& units);

/// The most telling figure: cushion curves, else curves over a grid, else distributions.
Plot study_plot(const StudyAnswers& answers, const UnitSystem& units);

/// A factor's value with its unit; for a material (unit "") its name.
std::string shown_factor(const std::string& unit, double value, const Material& material,
                         const UnitSystem& units);

}  // namespace dashpad
