#include "quantities/magnitude_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"

namespace dashpad {
namespace {

struct MeasuredDimension {
  std::string_view si_unit;
  Magnitudes bounds;
};

constexpr MeasuredDimension measured[] = {
    {"m", {1e-9, 1e6}},    {"m/s", {1e-9, 1e6}}, {"m/s2", {1e-8, 1e9}},  {"s", {1e-9, 1e12}},
    {"1/s", {1e-12, 1e9}}, {"kg", {1e-9, 1e9}},  {"Pa", {1e-6, 1e12}},   {"N", {1e-9, 1e12}},
    {"V", {1e-12, 1e6}},   {"m2", {1e-15, 1e9}}, {"kg/m3", {1e-6, 1e6}}, {"N/m", {1e-9, 1e15}},
};

}  // namespace

bool Magnitudes::admit(double value) const {
  return value == 0 || (std::abs(value) >= least && std::abs(value) <= most);
}

Magnitudes measured_magnitudes(std::string_view si_unit) {
  const auto* found = std::ranges::find(measured, si_unit, &MeasuredDimension::si_unit);
  return found != std::end(measured) ? found->bounds : stated_magnitudes;
}

std::string rule_of(const Magnitudes& bounds, double value, const std::string& si_unit) {
  if (bounds.admit(value)) return "";
  return fmt::format("must have a magnitude between {:g} and {:g}{}", bounds.least, bounds.most,
                     si_unit == "1" ? "" : " in " + si_unit);
}

SiValue read_stated(std::string_view text, const std::string& si_unit) {
  SiValue read = read_si(text, si_unit);
  if (read.rule.empty()) read.rule = rule_of(stated_magnitudes, read.value, si_unit);
  return read;
}

double stated_si(std::string_view text, const std::string& si_unit) {
  const SiValue read = read_stated(text, si_unit);
  if (!read.rule.empty()) throw UnitError(read.rule);
  return read.value;
}

}  // namespace dashpad
