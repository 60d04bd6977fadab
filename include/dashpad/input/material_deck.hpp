#pragma once
/// Foams from decks of other solvers (LS-DYNA keywords, Radioss starter blocks) and from tables of
/// compression tests. docs/material-decks.md explains the conversion.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/reading.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::input {

/// A material with the decisions of its reader.
struct DeckMaterial {
  Material material;
  std::string card;                      ///< "*MAT_083", "/MAT/LAW90", "table"
  long id = 0;                           ///< its number in the deck; 0 in a table
  int line = 0;                          ///< where it begins
  std::vector<std::string> assumptions;  ///< assumptions where the file says nothing, a sentence each
  std::vector<std::string> differences;  ///< what the card cannot hold, or is solved otherwise here
};

/// The foams of a deck, in its order, with their curves: *MAT_057, 063, 083 and 163 of LS-DYNA, /MAT/LAW33,
/// LAW62, LAW70 and LAW90 of Radioss. `units` are those of the deck, which does not state them. Reports all
/// faults, or the first 200; a deck without such a material is a fault.
Reading<std::vector<DeckMaterial>> read_material_deck(const std::filesystem::path& file,
                                                      const UnitSystem& units);

/// The consistent system of that name, whose units may be in any order: "mm-t-s" is "t-mm-s". Throws
/// std::invalid_argument with the available systems.
const UnitSystem& deck_system(std::string_view name);

/// Reads a column called strain, a pure number or in %, and columns of stress with units ("stress_kPa"). Of
/// several stresses, each header has the rate after an @: "stress_kPa @ 10 1/s". `rate`, 1/s, applies to a
/// single stress without a rate. A stress may be empty after its curve ends. Reports at most 200 faults.
Reading<DeckMaterial> read_stress_table(const std::filesystem::path& file, std::optional<double> rate);

}  // namespace dashpad::input
