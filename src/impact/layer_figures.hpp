#pragma once
/// What each layer of a pad went through, read off the history of a run.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// One for each layer; none where the history has no layers.
std::vector<LayerSummary> layer_summaries(const Pad& pad, const History& history);

/// Why a result is extrapolated, a reason each: layers beyond what they were tested for, that which was
/// first there first.
std::vector<Extrapolation> layer_extrapolations(const Pad& pad, const std::vector<LayerSummary>& layers);

}  // namespace dashpad
