#pragma once
/// Whether what a panel is made of fits together.

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// Throws std::invalid_argument if columns of a series differ in length, or if an axis cannot have its
/// limits.
void check(const Panel& panel);

}  // namespace dashpad::output
