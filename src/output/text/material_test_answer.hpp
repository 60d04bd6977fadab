#pragma once
/// The sentence that answers what a material test was made for, and its numbers as people read them.

#include <string>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The fastest, of which the answer speaks.
const laboratory::MaterialTestRun& headline_run(const laboratory::MaterialTestReport& report);

/// Whether the efficiency has a maximum on the way, rather than at the end of the first loading: only then
/// does the foam run out.
bool runs_out(const laboratory::MaterialTestRun& run);

/// Values of a run with three digits, large ones too; SI inside.
struct MaterialTestValues {
  const UnitSystem& units;

  [[nodiscard]] std::string stress(double value) const;   ///< "427 kPa"
  [[nodiscard]] std::string energy(double value) const;   ///< a volume: "1760 kJ/m³"
  [[nodiscard]] static std::string strain(double value);  ///< "0.558"
  [[nodiscard]] static std::string share(double value);   ///< "82.9 %"
};

/// "Best used at 427 kPa: it has then taken 157 kJ/m³ (at 100 per second)". For limits what is taken below
/// the first of them, for held strains and stresses what is kept.
std::string material_test_answer(const laboratory::MaterialTestReport& report, const UnitSystem& units);

}  // namespace dashpad::output
