#pragma once
/// The motion after an impact and where its energy went, for people and for programs.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/post_impact.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// `impact` is the case as solved: with the reduced mass M1 M2 / (M1 + M2) and the speed of approach V1 - V2,
/// with which the relative motion of two free bodies is that of one body against a wall.
Document post_impact_document(const Body& first, const Body& second, const ImpactCase& impact,
                              const Solution& solution, const UnitSystem& units);
std::string post_impact_json(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution);

}  // namespace dashpad::output
