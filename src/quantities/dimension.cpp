#include "quantities/dimension.hpp"

#include <algorithm>

namespace dashpad {
namespace {

constexpr Dimension dimensions[] = {
    {"m", "a length", {"m", "mm", "in", "ft"}},
    {"m/s", "a speed", {"m/s", "km/h", "mph", "in/s"}},
    {"m/s2", "an acceleration", {"m/s2", "ft/s2", "gravity"}},
    {"s", "a time", {"s", "ms"}},
    {"1/s", "a rate", {"1/s", "1/ms"}},
    {"kg", "a mass", {"kg", "g", "lb"}},
    {"N", "a force", {"N", "kN", "lbf", "kgf"}},
    {"N/m", "a stiffness", {"N/m", "N/mm", "kN/m", "lbf/in"}},
    {"N s/m", "a damping", {"N s/m", "kN s/m", "lbf s/in"}},
    {"Pa", "a stress", {"Pa", "kPa", "MPa", "psi"}},
    {"J", "an energy", {"J", "kJ", "ft lbf", "in lbf"}},
    {"N s", "an impulse", {"N s", "lbf s"}},
    {"kg/m3", "a density", {"kg/m3", "g/cm3", "lb/ft3"}},
    {"kg/m2", "a mass per area", {"kg/m2", "g/m2", "lb/ft2"}},
    {"V", "a voltage", {"V", "mV"}},
    {"m2", "an area", {"m2", "mm2", "in2"}},
    {"m3", "a volume", {"m3", "cm3", "in3"}},
    {"rad", "an angle", {"deg", "rad"}},
    {"K", "a temperature", {"degC", "degF", "K"}},
    {"1", "a pure number", {}},
};

}  // namespace

std::span<const Dimension> known_dimensions() { return dimensions; }

Dimension dimension_of(std::string_view si_unit) {
  const auto* found = std::ranges::find(dimensions, si_unit, &Dimension::si_unit);
  return found != std::end(dimensions) ? *found : Dimension{si_unit, "", {si_unit}};
}

}  // namespace dashpad
