#pragma once

namespace dashpad::uncertainty {

/// Of Student's t, the quantile for both sides: P(|t| < it) = 0.95. Infinite without a degree of freedom;
/// their number may be broken.
[[nodiscard]] double student_95(double degrees_of_freedom);

}  // namespace dashpad::uncertainty
