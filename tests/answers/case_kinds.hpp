#pragma once
/// The random cases by the names that the programs of this folder have for them.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "property/case_of_practice.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {

struct CaseKind {
  const char* name;
  ImpactCase (*draw)(std::uint64_t seed);
};

inline constexpr CaseKind case_kinds[] = {
    {"ordinary", ordinary_case}, {"plausible", plausible_case}, {"practice", case_of_practice},
    {"extreme", random_case},    {"nose", nose_case},           {"foam", foam_case},
    {"layered", layered_case},   {"moving", moving_case}};

inline std::vector<std::string> names_of_case_kinds() {
  std::vector<std::string> names;
  for (const CaseKind& kind : case_kinds) names.emplace_back(kind.name);
  return names;
}

/// `kind` is one of the names.
inline ImpactCase draw_case(const std::string& kind, std::uint64_t seed) {
  return std::ranges::find(case_kinds, kind, &CaseKind::name)->draw(seed);
}

/// In a line: "crushable-foam, sphere, linear + damping, gravity".
inline std::string words_of(const ImpactCase& impact) {
  const Pad& pad = impact.pad;
  std::string text =
      pad.layers.empty() ? name_of(pad.material.law) : fmt::format("{} layers", pad.layers.size());
  text += ", " + name_of(impact.impactor.nose);
  const std::size_t points = impact.support.points().size();
  text += points == 0 ? ", rigid" : points == 1 ? ", linear" : ", curve";
  for (const Parameter<Backing>& part : Backing::parameters)
    if (part.of(impact.backing) > 0) text += fmt::format(" + {}", part.key);
  if (pad.sheet > 0) text += ", sheet";
  if (impact.impactor.gravity > 0) text += ", gravity";
  if (impact.blows) text += fmt::format(", {} blows", impact.blows->count);
  return text;
}

}  // namespace dashpad::test
