#pragma once
/// The window of a head injury criterion below its curve.

#include <cstddef>
#include <string>
#include <utility>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// A bracket just above the axis of time, from the begin of the window to its end; a wash over half of the
/// plot would hide what it is about. `peak`, with its sign, is that of the curve; `row` counts brackets from
/// the axis on.
inline Series hic_bracket(std::string label, double begin, double end, double peak, std::size_t turn,
                          int row = 0) {
  const double foot = (0.02 + 0.11 * row) * peak, arm = foot + 0.05 * peak;
  return {.label = std::move(label),
          .style = SeriesStyle::solid_line,
          .x = {begin, begin, end, end},
          .y = {arm, foot, foot, arm},
          .turn = turn,
          .label_place = LabelPlace::middle};
}

}  // namespace dashpad::output
