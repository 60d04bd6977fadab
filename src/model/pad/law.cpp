#include "dashpad/model/pad/law.hpp"

#include <optional>
#include <type_traits>
#include <utility>

#include "model/pad/foam/foam_rules.hpp"
#include "model/parameter_values.hpp"

namespace dashpad {
namespace {

// The rules between parameters. They are written so that NaN, which breaks its bounds, breaks none of them.

template <class Law>
void check_rules(const Law&, std::vector<Violation>&) {}

void check_rules(const LinearViscoelastic& law, std::vector<Violation>& broken) {
  if (law.initial_modulus < law.asymptotic_modulus)
    broken.push_back({"initial_modulus", law.initial_modulus, "must be at least asymptotic_modulus"});
}

void check_rules(const RigidFoam& law, std::vector<Violation>& broken) {
  if (law.crush_strain >= law.second_strain)
    broken.push_back({"second_strain", law.second_strain, "must be more than crush_strain"});
  if (law.second_stress < law.crush_stress)
    broken.push_back({"second_stress", law.second_stress, "must be at least crush_stress"});
}

void check_rules(const TwentyOneParameter& law, std::vector<Violation>& broken) {
  // Otherwise the rate stress would be steeper at first contact than A, on which the contact integral rests.
  if (law.onset_strain_exponent <= law.contact_exponent)
    broken.push_back(
        {"onset_strain_exponent", law.onset_strain_exponent, "must be more than contact_exponent"});
  if (law.growth_strain_exponent <= law.contact_exponent)
    broken.push_back(
        {"growth_strain_exponent", law.growth_strain_exponent, "must be more than contact_exponent"});
}

void check_rules(const ViscoelasticFoam& law, std::vector<Violation>& broken) {
  if (law.first_exponent == 0) broken.push_back({"first_exponent", 0, "must not be 0"});
  if (law.second_exponent == 0) broken.push_back({"second_exponent", 0, "must not be 0"});
}

}  // namespace

std::vector<Violation> violations(const PadLaw& law) {
  std::vector<Violation> broken;
  const auto check = [&broken](const auto& alternative) {
    check_bounds(alternative, "", broken);
    check_rules(alternative, broken);
  };
  std::visit(check, law);
  return broken;
}

const FoamCurves* foam_curves(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law& held) -> const FoamCurves* {
        if constexpr (SharesSlip<Law>) return &held.curves;
        return nullptr;
      },
      law);
}

bool has_curves(const PadLaw& law) { return foam_curves(law) != nullptr; }

BlowMemory blow_memory(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law&) {
        if constexpr (IsMemoryless<Law>)
          return Law::recovers ? BlowMemory::none : BlowMemory::crater;
        else if constexpr (std::is_same_v<Law, CrushableFoam>)
          return BlowMemory::crater;
        else
          return SharesSlip<Law> ? BlowMemory::largest_strain : BlowMemory::none;
      },
      law);
}

std::vector<double> softening_rates(const PadLaw& law) {
  const FoamCurves* const curves = foam_curves(law);
  return curves ? softening_rates(*curves) : std::vector<double>();
}

std::string name_of(const PadLaw& law) {
  return std::visit([](const auto& alternative) { return std::string(alternative.name); }, law);
}

}  // namespace dashpad
