#pragma once
/// Documents of material cards, and of a test of one with its JSON, CSV and still.

#include <string>
#include <vector>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// A row a material: name, law, density, tested strains and rates, basis, reservations in short.
Document materials_document(const std::vector<Material>& materials, const UnitSystem& units,
                            Pictures pictures = Pictures::left_out);

/// The document of a material: reservations, source, law, tested range, parameters and some stresses.
Document material_document(const Material& material, const UnitSystem& units,
                           Pictures pictures = Pictures::left_out);

/// The loading curves of a material at each tested rate, up to or slightly beyond the tested strain.
Plot material_plot(const Material& material, const UnitSystem& units);

/// The loading curves of several materials at their slowest tested rates, solid as far as they were tested,
/// dashed beyond. Materials whose names begin with the same word have the same colour.
Plot materials_plot(const std::vector<Material>& materials, const UnitSystem& units);

/// A material test: where the foam is used best, flags, and tables with a row a rate.
Document material_test_document(const laboratory::MaterialTestReport& report, const UnitSystem& units,
                                Pictures pictures = Pictures::left_out);
/// Everything, in SI; keys name the units.
std::string material_test_json(const laboratory::MaterialTestReport& report);
/// CSV with a header and a row for each output: rate of the run, time, strain, strain_rate, stress and, on
/// request, stress_1984 where the update of 1984 has a value. The header has the units. Numbers read back
/// exactly; missing ones are empty.
std::string material_test_csv(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// A still: stress over strain with a curve for each rate, and efficiency over stress. For relaxation and
/// creep the first panel is over time. Flags and the source of the material are in the small print.
Plot material_test_plot(const laboratory::MaterialTestReport& report, const UnitSystem& units);

}  // namespace dashpad::output
