#include "dashpad/injury/measured_pulse.hpp"

#include <cmath>

namespace dashpad::injury {

std::vector<double> resultant_of(const std::vector<std::vector<double>>& components) {
  std::vector<double> length(components.empty() ? 0 : components.front().size());
  for (const std::vector<double>& component : components)
    for (std::size_t i = 0; i < length.size(); ++i) length[i] = std::hypot(length[i], component[i]);
  return length;
}

}  // namespace dashpad::injury
