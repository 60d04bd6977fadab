// Presets of test standards.

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "dashpad/input/standard_file.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

void require_sound(const std::optional<double>& value) {
  require(!value || (*value > 0 && std::isfinite(*value)), "a value of a standard is finite and more than 0");
}

void require_sound(const injury::StandardValue& value) {
  require_sound(value.value);
  require_sound(value.drop_height);
}

void require_sound(const injury::Standard& standard) {
  for (const injury::StandardValue* value : {&standard.mass, &standard.radius, &standard.speed})
    require_sound(*value);
  require(!standard.criteria.empty(), "a standard has a criterion");
  for (const injury::Criterion& criterion : standard.criteria) {
    require_sound(std::optional{criterion.limit});
    if (criterion.has_level()) require_sound(std::optional{criterion.level});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto standard = read_or_refuse(
      [&] { return input::read_standard(write("standard.toml", text_of(bytes, size))).value(); });
  if (!standard) return 0;
  require_sound(*standard);
  std::vector<std::string> all;
  for (const injury::StandardVariant& variant : standard->variants) {
    require_sound(injury::with_variants(*standard, {variant.name}));
    all.push_back(variant.name);
  }
  try {
    require_sound(injury::with_variants(*standard, all));
  } catch (const std::invalid_argument&) {  // two that replace the same value
  }
  return 0;
}
