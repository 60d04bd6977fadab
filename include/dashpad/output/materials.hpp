#pragma once
/// Material cards for people, all of them side by side or one whole, and a test of one for people and for
/// programs.

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

/// A material: title, reservations, source, law, tested range, parameters with symbol, value, unit and
/// meaning, and the stress at a few strains.
Document material_document(const Material& material, const UnitSystem& units,
                           Pictures pictures = Pictures::left_out);

/// The loading curves of one material, at each rate that it was tested at, up to where it was tested or a
/// little beyond.
Plot material_plot(const Material& material, const UnitSystem& units);

/// The loading curves, each at the slowest rate that its foam was tested at: solid as far as it was tested,
/// dashed beyond. Materials whose names begin with the same word have the same colour.
Plot materials_plot(const std::vector<Material>& materials, const UnitSystem& units);

/// A material test: where the foam is used best, flags, and tables with a row a rate.
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
