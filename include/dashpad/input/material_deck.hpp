#pragma once
/// Foams from decks of other solvers (LS-DYNA keywords, Radioss starter blocks) and from tables of
/// compression tests. docs/material-decks.md explains the conversion.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::input {

/// A material with the decisions of its reader.
struct DeckMaterial {
  Material material;
  std::string card;   ///< "*MAT_083", "/MAT/LAW90", "table"
  long id = 0;        ///< its number in the deck; 0 in a table
  int line = 0;       ///< where it begins
  std::string units;  ///< "t-mm-s", or "t-mm-s, as the deck states on line 4"; empty for a table
  std::vector<std::string> assumptions;  ///< assumptions where the file says nothing, a sentence each
  std::vector<std::string> differences;  ///< what the card cannot hold, or is solved otherwise here
};

/// Whether the files that a deck includes are read: those in its folder and below it alone.
enum class Includes { ignored, allowed };

/// The foams of a deck, in its order, with their curves: *MAT_057, 063, 083 and 163 of LS-DYNA, /MAT/LAW33,
/// LAW62, LAW70 and LAW90 of Radioss, *LOW DENSITY FOAM and *HYPERFOAM of Abaqus. `units` are those of the
/// deck; they must agree with those that it states (/BEGIN, /UNIT, *CONTROL_UNITS), and may be left out if it
/// states them. Reports all faults, or the first 200; a deck without such a material is a fault.
Reading<std::vector<DeckMaterial>> read_material_deck(const std::filesystem::path& file,
                                                      const std::optional<UnitSystem>& units,
                                                      Includes includes = Includes::ignored);

/// The consistent system of that name, whose units may be in any order: "mm-t-s" is "t-mm-s". Throws
/// std::invalid_argument with the available systems.
const UnitSystem& deck_system(std::string_view name);

/// Whether to read `file` as tables of tests, by its first keyword or row of numbers; false where it cannot
/// be read.
bool is_stress_table(const std::filesystem::path& file);

/// How the tests in files were made, in the order of the files.
struct TestConditions {
  std::vector<double> rates = {};  ///< 1/s, of the files with a single stress; may be fewer
  /// K, one for each file, or none. The first is that of the card; others become its temperature table.
  std::vector<double> temperatures = {};
};

/// Makes a foam of tests in tables: a column of strain or displacement, and columns of stress or force
/// (`wanted` names them). Of several stresses in a file, each header has the rate behind an at sign:
/// `stress_kPa @ 10 1/s`. Loadings follow the largest strain so far; that of the slowest test is made to rise
/// within its noise, and its way back is the unloading curve. What moved or was left out is in `differences`.
/// Reports at most 200 faults a file.
Reading<DeckMaterial> read_stress_tables(const std::vector<std::filesystem::path>& files,
                                         const TestConditions& conditions, const StressStrainColumns& wanted);

}  // namespace dashpad::input
