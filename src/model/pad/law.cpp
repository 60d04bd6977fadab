#include "dashpad/model/pad/law.hpp"

#include <fmt/format.h>

#include <cmath>

namespace dashpad {
namespace {

/// Far beyond anything that can be measured, in any unit; keeps products of parameters from overflowing.
constexpr double largest_magnitude = 1e15;

std::string describe(const Bounds& bounds, std::string_view unit) {
  const std::string suffix = unit == "1" ? "" : fmt::format(" {}", unit);
  std::string rule = "must be a finite number";
  if (std::isfinite(bounds.lowest))
    rule = fmt::format("must be {}{}{}", bounds.lowest_admitted ? "at least " : "more than ", bounds.lowest,
                       suffix);
  if (std::isfinite(bounds.highest))
    rule += fmt::format(" and {}{}{}", bounds.highest_admitted ? "at most " : "less than ", bounds.highest,
                        suffix);
  return rule;
}

bool is_out_of_scale(double value) {
  const double magnitude = std::abs(value);
  return magnitude > largest_magnitude || (magnitude > 0 && magnitude < 1 / largest_magnitude);
}

template <class Law>
void check_bounds(const Law& law, std::vector<Violation>& broken) {
  for (const auto& parameter : Law::parameters) {
    const double value = law.*parameter.member;
    if (!parameter.bounds.contain(value))
      broken.push_back({parameter.key, value, describe(parameter.bounds, parameter.unit)});
    else if (is_out_of_scale(value))
      broken.push_back({parameter.key, value,
                        fmt::format("must have a magnitude between {} and {} in {}", 1 / largest_magnitude,
                                    largest_magnitude, parameter.unit)});
  }
}

// The rules between parameters. All are written so that a value that is not a number, which breaks its bounds
// already, breaks none of them.

void check_rules(const Elastic&, std::vector<Violation>&) {}

void check_rules(const LinearViscoelastic& law, std::vector<Violation>& broken) {
  if (law.initial_modulus < law.asymptotic_modulus)
    broken.push_back({"initial_modulus", law.initial_modulus, "must not be below asymptotic_modulus"});
}

void check_rules(const RigidFoam& law, std::vector<Violation>& broken) {
  if (law.crush_strain >= law.second_strain)
    broken.push_back({"second_strain", law.second_strain, "must be more than crush_strain"});
  if (law.second_stress < law.crush_stress)
    broken.push_back({"second_stress", law.second_stress, "must not be below crush_stress"});
}

void check_rules(const NineParameter&, std::vector<Violation>&) {}

void check_rules(const TwentyOneParameter& law, std::vector<Violation>& broken) {
  // Otherwise the rate stress would be steeper at first contact than A, on which the contact integral rests.
  if (law.onset_strain_exponent <= law.contact_exponent)
    broken.push_back(
        {"onset_strain_exponent", law.onset_strain_exponent, "must be more than contact_exponent"});
  if (law.growth_strain_exponent <= law.contact_exponent)
    broken.push_back(
        {"growth_strain_exponent", law.growth_strain_exponent, "must be more than contact_exponent"});
}

}  // namespace

std::vector<Violation> violations(const PadLaw& law) {
  std::vector<Violation> broken;
  const auto check = [&broken](const auto& alternative) {
    check_bounds(alternative, broken);
    check_rules(alternative, broken);
  };
  std::visit(check, law);
  return broken;
}

std::string name_of(const PadLaw& law) {
  return std::visit([](const auto& alternative) { return std::string(alternative.name); }, law);
}

}  // namespace dashpad
