#pragma once
/// What the cards of a study's materials leave uncertain, as factors.

#include <vector>

#include "dashpad/study/study.hpp"
#include "uncertainty/foam_factors.hpp"

namespace dashpad::study {

using uncertainty::FoamFactor;

/// Those of the case, or of all materials that it is given.
std::vector<FoamFactor> foam_factors(const Study& study);

/// Adds the rule that a sound factor breaks if it leaves the range of what is uncertain, or goes beyond the
/// deviations that occur.
void check_foam_factor(const Factor& factor, const FoamFactor& known, std::vector<Violation>& broken);

}  // namespace dashpad::study
