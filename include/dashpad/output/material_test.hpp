#pragma once
/// A material test for people and for programs.

#include <string>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// What was done, flags, and tables with a row a rate.
std::string material_test_text(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// Everything, in SI; keys name the units.
std::string material_test_json(const laboratory::MaterialTestReport& report);
/// CSV text: a header row, then a row a place of output: the rate of the run, time, strain, strain_rate,
/// stress and, if asked for, stress_1984 at the places that the update of 1984 has. The header adds the
/// units. Numbers read back as the very same double; one that is absent is an empty field.
std::string material_test_csv(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// A still: stress over strain with one curve a rate, efficiency over stress. Of relaxation and creep what
/// changes over time is the first panel. Flags and the source of the material are in the small print.
Plot material_test_plot(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// The page of dashpad/output/page/figures_page.hpp: tables, all curves. Throws as figures_page() does.
std::string material_test_page(const laboratory::MaterialTestReport& report, const UnitSystem& units);

}  // namespace dashpad::output
