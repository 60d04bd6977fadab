#pragma once
/// What the terminal shows of an impact that was made up.

#include "dashpad/output/impact.hpp"

namespace dashpad::test {

inline std::string impact_text(const ImpactCase& impact, const Summary& summary,
                               const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units,
                               output::Detail detail, const std::vector<output::BlowResult>& blows = {}) {
  const Options options;
  Solution solution;
  solution.summary = summary;
  return output::to_terminal(output::impact_document({impact, options, solution, injury, blows}, units),
                             detail);
}

}  // namespace dashpad::test
