#pragma once
/// Material cards for people: all of them side by side, or one whole.

#include <string>
#include <vector>

#include "dashpad/model/pad/material.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// A table with a row a material: name, law, density, tested strains and rates, basis, reservations in short.
std::string materials_text(const std::vector<Material>& materials);

/// A material: title, source, reservations, law, parameters with symbol, value, unit and meaning, curves with
/// the stress at a few strains, and the tested range.
std::string material_text(const Material& material, const UnitSystem& units);

/// The loading curves, each at the slowest rate that its foam was tested at: solid as far as it was tested,
/// dashed beyond. Materials whose names begin with the same word have the same colour.
Plot materials_plot(const std::vector<Material>& materials, const UnitSystem& units);

}  // namespace dashpad::output
