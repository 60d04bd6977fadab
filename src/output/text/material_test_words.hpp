#pragma once
/// A material test in words and tables, before they are laid out: for the terminal, the page and the still.

#include <string>
#include <vector>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The procedure of a test in a sentence.
std::string test_words(const laboratory::MaterialTest& test, const UnitSystem& units);

/// "100 per second", or "measured".
std::string rate_words(const laboratory::MaterialTestRun& run);

/// The flags of all runs, each with the rates for which it is raised.
std::vector<std::string> flag_words(const laboratory::MaterialTestReport& report);

/// Sentences on how the numbers came about and how exact they are.
std::vector<std::string> notes_on(const laboratory::MaterialTestReport& report);

/// The unit of an energy per volume: "kJ/m³" goes with kPa.
std::string energy_density_unit(const UnitSystem& units);

/// Figures, then what the test has besides: stress limits, relaxation, creep, the update of 1984, events.
std::vector<Table> tables_of(const laboratory::MaterialTestReport& report, const UnitSystem& units);

/// The fastest, of which the answer speaks.
const laboratory::MaterialTestRun& headline_run(const laboratory::MaterialTestReport& report);

/// Whether the efficiency has a maximum before the end of the first loading, so that the foam runs out.
bool runs_out(const laboratory::MaterialTestRun& run);

/// Values of a run with three digits, large ones too; SI inside.
struct MaterialTestValues {
  const UnitSystem& units;

  [[nodiscard]] std::string stress(double value) const;  ///< "427 kPa"
  [[nodiscard]] std::string energy(double value) const;  ///< per volume: "1760 kJ/m³"
  [[nodiscard]] static std::string share(double value);  ///< "82.9 %"
};

/// The answer of a test: "Best used up to 427 kPa, having absorbed 157 kJ/m³ (at 100 per second)"; with
/// stress limits the energy below the first, for relaxation and creep what is kept.
std::string material_test_answer(const laboratory::MaterialTestReport& report, const UnitSystem& units);

}  // namespace dashpad::output
