#pragma once
/// The figures of an answer one by one, with the error that the answer states for each.

#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::test {

struct AnswerFigure {
  const char* name = "";
  double value = 0;     ///< SI
  double scale = 0;     ///< what its error is relative to
  double estimate = 0;  ///< stated error, over the scale
  /// Error that a tolerance allows, over the tolerance and the scale; 0 for a figure that is not held to it.
  double allowed = 1;
};

/// Of one blow: those of the summary, then those of the pulse where that is whole.
std::vector<AnswerFigure> figures_of(const ImpactCase& impact, const Solution& solution);

}  // namespace dashpad::test
