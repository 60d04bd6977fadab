#pragma once
/// A material test for people and for programs.

#include <string>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Where the foam is used best, flags, and tables with a row a rate.
Document material_test_document(const laboratory::MaterialTestReport& report, const UnitSystem& units,
                                Pictures pictures = Pictures::left_out);
/// Everything, in SI; keys name the units.
std::string material_test_json(const laboratory::MaterialTestReport& report);
/// CSV text: a header row, then a row a place of output: the rate of the run, time, strain, strain_rate,
/// stress and, if asked for, stress_1984 at the places that the update of 1984 has. The header adds the
/// units. Numbers read back as the very same double; one that is absent is an empty field.
std::string material_test_csv(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// A still: stress over strain with one curve a rate, efficiency over stress. Of relaxation and creep what
/// changes over time is the first panel. Flags and the source of the material are in the small print.
Plot material_test_plot(const laboratory::MaterialTestReport& report, const UnitSystem& units);

}  // namespace dashpad::output
