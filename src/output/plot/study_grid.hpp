#pragma once
/// The rows of a grid as cells: where each stands, and the response there.

#include <map>
#include <vector>

#include "dashpad/study/questions.hpp"

namespace dashpad::output {

/// Two factors of a grid and a response over them; other factors at their middle level. Levels increase.
struct GridPlane {
  std::size_t across = 0;                   ///< factor with the most levels
  std::optional<std::size_t> lines;         ///< the next one
  std::vector<double> across_levels;        ///< SI
  std::vector<double> line_levels;          ///< SI; {0} without a second factor
  std::vector<std::vector<double>> values;  ///< [line][across], SI; NaN for none, infinite: struck through
  /// Of draws, the 5 % and 95 % quantiles beside them; empty without draws.
  std::vector<std::vector<double>> low, high;
  std::string at;          ///< levels of the other factors, in words; may be empty
  bool is_median = false;  ///< of draws, not of single rows
};

/// Absent where no number has two levels or more. `response` counts in StudyAnswers::responses.
std::optional<GridPlane> grid_plane(const study::StudyAnswers& answers, std::size_t response,
                                    const UnitSystem& units);

}  // namespace dashpad::output
