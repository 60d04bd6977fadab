#pragma once
/// What a test and a computed impact have to compare.

#include "dashpad/impact/solution.hpp"
#include "dashpad/report1986/validation/held_out.hpp"

namespace dashpad::report1986 {

/// The figures of an impact in the report's units; program and setup are left to the caller.
Prediction figures_of(const Summary& summary);

/// ln(predicted / measured), of strains the difference.
double error_of(const Reading& reading, double predicted);

}  // namespace dashpad::report1986
