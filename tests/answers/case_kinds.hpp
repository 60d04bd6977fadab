#pragma once
/// The random cases by the names that the programs of this folder have for them.

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

}  // namespace dashpad::test
