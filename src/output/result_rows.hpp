#pragma once
/// A result in words and figures before it is laid out: for terminal and page.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "output/document.hpp"

namespace dashpad::output {

/// How it ended, in one sentence.
std::string outcome(const Summary& summary);

/// What to beware of, each beginning with a word in capitals: the flags of
/// dashpad/impact/flags.hpp, with moments in the units of the reader.
std::vector<std::string> warnings(const Summary& summary, const UnitSystem& units);

/// Every figure of the impact; none if nothing was run.
std::vector<ValueRow> summary_rows(const ImpactCase& impact, const Summary& summary, const UnitSystem& units,
                                   Detail detail);

/// The figures of the pulse. With Detail::main, those that are asked for first, and equal ones in one row.
std::vector<ValueRow> pulse_rows(const injury::InjuryFigures& figures, const UnitSystem& units,
                                 Detail detail);

/// The rows that people ask for first: those of the pulse, then those of the impact, none twice.
std::vector<ValueRow> main_rows(const ImpactCase& impact, const Summary& summary,
                                const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units);

/// The speed that was left when the pad bottomed out, beside that of the impact; none if it did not.
std::vector<ValueRow> bottoming_figures(const ImpactCase& impact, const Summary& summary,
                                        const UnitSystem& units);

/// The numbers behind the numbers: "to a tolerance of 0.01 %: 120 steps, contact force in closed form, 3
/// runs, 1.2 ms".
std::string numbers_text(const Summary& summary);

/// "from 5.847 to 20.12 ms", with 0 for what is 0 up to rounding.
std::string stretch(double begin, double end, const UnitSystem& units, int digits);

}  // namespace dashpad::output
