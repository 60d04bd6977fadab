#pragma once
/// What a reader must know before relying on a result.

#include <string>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad {

struct Flag {
  std::string name;  ///< NOT RUN, TOLERANCE NOT MET, TIME LIMIT, BOTTOMED or EXTRAPOLATED
  std::string text;  ///< a line that begins with the name
};

/// None for a result without reservations. EXTRAPOLATED comes once for each reason.
std::vector<Flag> flags(const Summary& summary);

}  // namespace dashpad
