#pragma once
/// Material cards for people: all of them side by side, or one whole.

#include <vector>

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

}  // namespace dashpad::output
