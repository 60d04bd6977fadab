#pragma once
/// The figures that get an interval, of a solved impact.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad::uncertainty {

struct FigureName {
  /// What a share of the acceleration or of the penetration is a share of.
  enum class Kind { acceleration, hic, hic_d, dwell, penetration, rebound };

  std::string key;
  Kind kind = Kind::acceleration;
  double level = 0;  ///< m/s2, of a dwell time
};

/// All of them; with a dwell time for each level.
std::vector<FigureName> figure_names(std::span<const double> dwell_levels);

/// Their values, SI; NaN where the impact has none.
std::vector<double> figures_of(const Solution& solution, std::span<const FigureName> names);

}  // namespace dashpad::uncertainty
