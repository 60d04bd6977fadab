#pragma once
/// What came of each blow of a series, as texts, files and pages show it.

#include <optional>
#include <span>
#include <vector>

#include "dashpad/impact/blows.hpp"
#include "dashpad/injury/figures.hpp"

namespace dashpad::output {

struct BlowResult {
  Summary summary;
  std::optional<injury::InjuryFigures> injury;  ///< absent where the pulse is not whole
  double earlier_penetration = 0;               ///< that the blow met, m
};

std::vector<BlowResult> blow_results(std::span<const Blow> blows);

}  // namespace dashpad::output
