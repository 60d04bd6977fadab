#pragma once
/// Repeated blows on one pad (theory.md, Eqs. 46 to 48): the same nose, mass and speed at the same place,
/// with rests between that outlast every relaxation of the pad.

#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

struct Blow {
  ImpactCase impact;  ///< one blow on the pad as the earlier ones have left it
  Solution solution;
};

/// The blows of ImpactCase::blows in turn; without them the one that the case is. The series ends early with
/// a blow that does not say what it leaves behind: leaves_a_known_pad()
/// of dashpad/impact/flags.hpp. Throws as solve() does.
std::vector<Blow> solve_blows(const ImpactCase& impact, const Options& options = {});

}  // namespace dashpad
