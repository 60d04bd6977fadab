#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dashpad {

/// The system of units of that name; `name_of` gives the name of one. Throws std::invalid_argument that names
/// the systems on offer.
template <class System, class NameOf>
const System& named_system(const std::vector<System>& systems, std::string_view name, NameOf name_of) {
  std::string names;
  for (const System& system : systems) {
    if (name_of(system) == name) return system;
    names += (names.empty() ? "" : ", ") + name_of(system);
  }
  throw std::invalid_argument("unit system \"" + std::string{name} + "\": must be one of " + names);
}

}  // namespace dashpad
