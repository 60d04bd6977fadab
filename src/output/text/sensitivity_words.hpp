#pragma once
/// Words for what each number of a case does to the figures.

#include <string>
#include <vector>

#include "dashpad/output/sensitivity.hpp"

namespace dashpad::output {

/// The inputs by their effect on a figure, the largest first; those without a derivative last.
std::vector<std::size_t> by_effect(const sensitivity::Answer& answer, std::size_t figure);

/// The first of these with an effect that can be seen, each thing once: a drop height is a speed by another
/// name.
std::vector<std::size_t> seen_effects(const sensitivity::Answer& answer, std::size_t figure, std::size_t max);

/// "+1.117 %", "-0.02 ± 0.01 %", "kink, +0.3 %", "jump", "-": what 1 % more does, with the digits that the
/// error leaves.
std::string effect_words(const sensitivity::Elasticity& elasticity);

/// "-12 % to +8 %".
std::string interval_of_foam(const FigureInterval& interval);

}  // namespace dashpad::output
