// Quantities with a unit, and sensitivities.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

constexpr std::array si_units{"m",  "m/s", "m/s2", "s",     "1/s", "kg", "N",  "N/m",
                              "Pa", "J",   "N s",  "kg/m3", "V",   "m2", "m3", "1"};

/// Nothing for text that is refused.
std::optional<double> read(const std::string& text, const std::string& unit) {
  try {
    return to_si(text, unit);
  } catch (const UnitError& error) {
    require(*error.what() != '\0', "a refusal has a reason");
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(text_of(bytes, size));
  for (const char* unit : si_units)
    if (const auto value = read(text, unit)) {
      require_finite({*value}, "a quantity is finite");
      require(to_si(fmt::format("{} {}", *value, std::string(unit) == "1" ? "" : unit), unit) == *value,
              "what is written is read as the same");
    }
  try {
    const double sensitivity = input::sensitivity_of(text).volts_per_acceleration;
    require(sensitivity > 0 && std::isfinite(sensitivity), "a sensitivity is finite and more than 0");
  } catch (const UnitError&) {  // no sensitivity
  }
  return 0;
}
