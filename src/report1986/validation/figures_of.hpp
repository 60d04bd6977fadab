#pragma once
/// What a computed impact has to compare with a test.

#include "dashpad/impact/solution.hpp"
#include "dashpad/report1986/validation/simulations.hpp"

namespace dashpad::report1986 {

/// The figures of an impact in the report's units; program and setup are left to the caller.
Prediction figures_of(const Summary& summary);

}  // namespace dashpad::report1986
