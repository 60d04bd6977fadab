#include "dashpad/spit1984/deck.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "quantities/text.hpp"

namespace dashpad::spit1984 {

namespace {

/// Published values that PAD stores after those that it uses, by their names in cards: the ninth of law 4 and
/// the 17th to 21st of law 5 (Table A-1).
constexpr std::array stored_only{
    std::pair{std::string_view{"zero_time_modulus"}, 9},
    std::pair{std::string_view{"zero_time_stress_factor"}, 17},
    std::pair{std::string_view{"zero_time_strain_factor_a"}, 18},
    std::pair{std::string_view{"zero_time_strain_factor_b"}, 19},
    std::pair{std::string_view{"zero_time_strain_factor_c"}, 20},
    std::pair{std::string_view{"zero_time_strain_factor_d"}, 21},
};

/// A number as typed, with nine significant digits.
double typed(double value) { return rounded_to(value, 9); }

double typed(double value, const char* si_unit, const char* unit) {
  return typed(from_si(value, si_unit, unit));
}

/// A value of a card's `also_published` table: a number, or a stress with its unit.
double stored_value(const std::string& text) {
  try {
    return typed(to_si(text, "1"));
  } catch (const UnitError&) {
    return typed(to_si(text, "Pa"), "Pa", "psi");
  }
}

constexpr std::size_t laws_of_1984 = 5;

template <class Law>
void store_parameters(const Law& law, std::array<double, 21>& stored) {
  std::size_t position = 0;
  for (const auto& parameter : Law::parameters) {
    const double value = parameter.of(law);
    stored.at(position++) =
        std::string_view{parameter.unit} == "Pa" ? typed(value, "Pa", "psi") : typed(value);
  }
}

void store_published(const Material& material, PadKey key, std::array<double, 21>& stored) {
  for (const auto& published : material.also_published) {
    const auto* const place =
        std::find_if(stored_only.begin(), stored_only.end(),
                     [&published](const auto& entry) { return entry.first == published.first; });
    if (place == stored_only.end()) continue;
    if ((place->second == 9) != (key == PadKey::nine_parameter)) continue;
    try {
      stored[static_cast<std::size_t>(place->second) - 1] = stored_value(published.second);
    } catch (const UnitError&) {  // free text of a card; nothing computes with it
    }
  }
}

void store_support(const Support& support, Deck& deck) {
  const auto& points = support.points();
  deck.support = static_cast<int>(points.size());
  if (deck.support == 1) {
    deck.support_parameters[8] = typed(points[0].force / points[0].deflection, "N/m", "lbf/in");
    return;
  }
  for (std::size_t j = 0; j < points.size(); ++j) {
    deck.support_parameters[2 * j] = typed(points[j].deflection, "m", "in");
    deck.support_parameters[2 * j + 1] = typed(points[j].force, "N", "lbf");
  }
}

}  // namespace

std::vector<Violation> what_a_deck_cannot_say(const ImpactCase& impact) {
  std::vector<Violation> unsaid;
  const auto add = [&](const std::string& key, double value, const std::string& rule) {
    unsaid.push_back({key, value, rule});
  };
  if (!std::holds_alternative<Sphere>(impact.impactor.nose))
    add("impactor.nose", 0, "the 1984 program supports only a spherical nose");
  if (impact.blows) add("blows", 0, "the 1984 program supports only one blow");
  if (const double depth = impact.pad.earlier_penetration; depth > 0)
    add("pad.earlier_penetration", depth, "the 1984 program does not support earlier blows");
  if (impact.pad.sheet > 0)
    add("pad.sheet_mass_per_area", impact.pad.sheet, "the 1984 program does not support a sheet on the pad");
  if (impact.pad.area)
    add("pad.area", *impact.pad.area, "the 1984 program does not support a pad with an edge");
  if (impact.impactor.gravity != 0)
    add("impactor.gravity", impact.impactor.gravity, "the 1984 program does not support gravity");
  for (const Parameter<Backing>& parameter : Backing::parameters)
    if (const double value = parameter.of(impact.backing); value != 0)
      add(std::string("support.") + parameter.key, value,
          "the 1984 program's support has no mass or losses and is fixed to the ground");
  if (!impact.pad.layers.empty())
    add("pad.layers", double(impact.pad.layers.size()),
        "the 1984 program does not support a pad with several layers");
  else if (impact.pad.material.law.index() >= laws_of_1984)
    add("pad.law", 0,
        "the 1984 program has five laws, and " + name_of(impact.pad.material.law) + " is not one of them");
  const std::size_t points = impact.support.points().size();
  if (points == 0)
    add("support.type", 0,
        "the 1984 program has no rigid support (KEYS = 0 divides zero by zero); use a stiff linear support");
  if (points > 4)
    add("support.points", static_cast<double>(points),
        "the 1984 program accepts at most four points on a support curve");
  return unsaid;
}

Deck deck_of(const ImpactCase& impact) {
  Deck deck;
  deck.radius_in = typed(std::get<Sphere>(impact.impactor.nose).radius, "m", "in");
  deck.speed_mph = typed(impact.impactor.speed, "m/s", "mph");
  deck.weight_lb = typed(impact.impactor.mass, "kg", "lb");
  deck.thickness_in = typed(impact.pad.thickness, "m", "in");
  // The first laws of PadLaw are in the order of KEYP.
  deck.pad = static_cast<PadKey>(impact.pad.material.law.index() + 1);
  std::visit([&](const auto& law) { store_parameters(law, deck.pad_parameters); }, impact.pad.material.law);
  store_published(impact.pad.material, deck.pad, deck.pad_parameters);
  store_support(impact.support, deck);
  return deck;
}

std::vector<Violation> violations(const Deck& deck) {
  std::vector<Violation> broken;
  const auto check = [&](const std::string& name, double value, const char* meaning) {
    if (!(value > 0 && value <= 1e20))
      broken.push_back({name, value, fmt::format("{} must be more than 0 and at most 1e20", meaning)});
  };
  check("RAD", deck.radius_in, "the sphere's radius");
  check("VIN", deck.speed_mph, "the initial speed");
  check("WGT", deck.weight_lb, "the weight");
  check("THK", deck.thickness_in, "the pad's thickness");
  check("DELT", deck.time_step_ms, "the time step");
  check("NDEL", deck.print_interval, "the print interval");
  const int law = static_cast<int>(deck.pad);
  if (law < 1 || law > 5) broken.push_back({"KEYP", double(law), "must be from 1 to 5"});
  for (std::size_t i = 0; i < deck.pad_parameters.size(); ++i)
    if (!std::isfinite(deck.pad_parameters[i]))
      broken.push_back({fmt::format("PPAR({})", i + 1), deck.pad_parameters[i], "must be a finite number"});
  if (deck.support < 1 || deck.support > 4)
    broken.push_back({"KEYS", double(deck.support), "must be from 1 to 4"});
  else if (deck.support == 1)
    check("SPAR(9)", deck.support_parameters[8], "the support's stiffness");
  else
    for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(deck.support); ++i) {
      const double before = i < 2 ? 0 : deck.support_parameters[i - 2];
      const double value = deck.support_parameters[i];
      if (!(value > before && value <= 1e20))
        broken.push_back({fmt::format("SPAR({})", i + 1), value,
                          "the support's deflections and forces must increase from 0 and be at most 1e20"});
    }
  return broken;
}

ImpactCase with_the_constants_of_1984(ImpactCase impact) {
  const double inch = to_si("1 in", "m");
  impact.impactor.speed *= 17.64 * inch / to_si("1 mph", "m/s");
  impact.impactor.mass *= standard_gravity / (386.4 * inch);
  return impact;
}

}  // namespace dashpad::spit1984
