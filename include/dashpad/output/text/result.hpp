#pragma once
/// The result of one impact for people.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/blows.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// How much of a result people see.
enum class Detail {
  main,  ///< what matters first, to four digits; errors in one line, and where they are much larger than that
  all,   ///< every figure to five digits, each with its error
};
/// Significant digits of figures.
constexpr int digits_of(Detail detail) { return detail == Detail::all ? 5 : 4; }

/// How it ended, what to beware of, the figures, and what they rest on: case, errors. At most 100 columns
/// wide, as far as the words allow. `injury` is absent where the pulse is not whole.
/// `blows`: of a series, whose last blow the summary is.
std::string result_text(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units,
                        Detail detail, const std::vector<BlowResult>& blows = {});

}  // namespace dashpad::output
