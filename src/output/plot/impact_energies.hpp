#pragma once
/// Where the energy of an impact is, over time.

#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::output {

/// J, an entry for each of the history. Works are trapezoid sums of force over way, the work of the weight is
/// part of the total.
struct ImpactEnergies {
  std::vector<double> kinetic, support, pad, total;
  double largest_deviation = 0;  ///< of the total from what it was at first, as a share of that
};

ImpactEnergies impact_energies(const ImpactCase& impact, const History& history);

}  // namespace dashpad::output
