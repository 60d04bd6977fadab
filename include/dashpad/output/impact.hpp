#pragma once
/// One impact, or the last of a series of blows, for people.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/blows.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

struct ImpactReport {
  const ImpactCase& impact;
  const Options& options;
  const Solution& solution;
  std::optional<injury::InjuryFigures> injury = {};  ///< absent where the pulse is not whole
  std::vector<BlowResult> blows = {};                ///< of a series, whose last blow the solution is
  std::vector<ContactSnapshot> snapshots = {};       ///< for the page; may be empty
};

/// The answer, how it ended, what to beware of, the figures, and what they rest on.
Document impact_document(const ImpactReport& report, const UnitSystem& units,
                         Pictures pictures = Pictures::left_out);

/// The page. `shown` are the units at first; the reader may switch to the others.
std::string impact_page(const ImpactReport& report, const UnitSystem& shown);

}  // namespace dashpad::output
