#pragma once
/// Foams out of the decks of other solvers, LS-DYNA keywords and Radioss starter blocks, and out of tables of
/// compression tests. docs/material-decks.md says what is read and what becomes of it.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/reading.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::input {

/// A material as it was found, and what its reader had to decide.
struct DeckMaterial {
  Material material;
  std::string card;                      ///< "*MAT_083", "/MAT/LAW90", "table"
  long id = 0;                           ///< its number in the deck; 0 in a table
  int line = 0;                          ///< where it begins
  std::vector<std::string> assumptions;  ///< what the file does not say, and what was taken, a sentence each
  std::vector<std::string> differences;  ///< what the card cannot say or what is solved otherwise here
};

/// The foams of a deck, in its order: *MAT_057, 063, 083 and 163 of LS-DYNA, /MAT/LAW33, LAW62, LAW70 and
/// LAW90 of Radioss, with the curves that they name. `units` are those of the deck, which does not say them
/// itself. Gives all faults, or the first 200; a deck without such a material is a fault.
Reading<std::vector<DeckMaterial>> read_material_deck(const std::filesystem::path& file,
                                                      const UnitSystem& units);

/// The consistent system of that name, or of its units in another order: "mm-t-s" is "t-mm-s". Throws
/// std::invalid_argument that names the systems on offer.
const UnitSystem& deck_system(std::string_view name);

/// A column called strain, a pure number or in %, and columns of stress with their units ("stress_kPa"). With
/// several of them each header says its rate behind an @: "stress_kPa @ 10 1/s". `rate`, 1/s, is that of a
/// single column that does not say it. A stress may be left out where its curve has ended. Gives all faults,
/// or the first 200.
Reading<DeckMaterial> read_stress_table(const std::filesystem::path& file, std::optional<double> rate);

}  // namespace dashpad::input
