#pragma once
/// The panels of a material test: one curve a rate, in the colour of its turn everywhere.

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

Panel stress_over_strain(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// The time axis is logarithmic where the runs last so differently that a plain one would hide some, and for
/// relaxation and creep.
Panel stress_over_time(const laboratory::MaterialTestReport& report, const UnitSystem& units);
Panel strain_over_time(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// Of the first loading, as the rest.
Panel energy_over_strain(const laboratory::MaterialTestReport& report, const UnitSystem& units);
Panel efficiency_over_strain(const laboratory::MaterialTestReport& report);
Panel ideality_over_strain(const laboratory::MaterialTestReport& report);
/// With the stress limits that were asked for.
Panel efficiency_over_stress(const laboratory::MaterialTestReport& report, const UnitSystem& units);

}  // namespace dashpad::output
