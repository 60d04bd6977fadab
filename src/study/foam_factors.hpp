#pragma once
/// What the cards of a study's materials leave uncertain, as factors.

#include <vector>

#include "dashpad/study/study.hpp"
#include "uncertainty/foam_factors.hpp"

namespace dashpad::study {

using uncertainty::FoamFactor;

/// Those of the case, or of all materials that it is given.
std::vector<FoamFactor> foam_factors(const Study& study);

}  // namespace dashpad::study
