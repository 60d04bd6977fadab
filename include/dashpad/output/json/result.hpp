#pragma once
/// The result of one impact for other programs.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/blows.hpp"

namespace dashpad::output {

/// JSON text (RFC 8259, UTF-8, ends with a line break) that schema/summary.schema.json describes: the
/// summary, the case that it belongs to and the program that made it. SI units, which the keys name. Every
/// number reads back as the very same double; a figure that is absent or not finite is null.
/// `injury` is null in the JSON where there are no figures. `blows`: of a series, whose last blow the summary
/// is; null if there are none.
std::string result_json(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury = std::nullopt,
                        const std::vector<BlowResult>& blows = {});

}  // namespace dashpad::output
