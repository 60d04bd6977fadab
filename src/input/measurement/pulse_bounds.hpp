#pragma once
/// What no sensor gives is refused before it is computed with.

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/measured_pulse.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// Faults where the samples are nearer to each other or further from time 0 than any test has them, or the
/// largest acceleration is no impact's. A pulse that is 0 throughout is admitted. `line`: of the first
/// sample; 0 where it has none.
void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults);

}  // namespace dashpad::input
