#pragma once
/// The figures that get an interval, of a solved impact.

#include <limits>
#include <span>
#include <vector>

#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::uncertainty {

struct AskedFigure {
  const ResultQuantity* quantity;
  double level = 0;  ///< m/s2, of a dwell time
};

/// All of them; with a dwell time for each level.
std::vector<AskedFigure> asked_figures(std::span<const double> dwell_levels);

/// Their values, SI; NaN where the impact has none.
std::vector<double> figures_of(const Solution& solution, std::span<const AskedFigure> asked);

}  // namespace dashpad::uncertainty
