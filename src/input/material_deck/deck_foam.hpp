#pragma once
/// A foam as a deck or a table describes it, in SI, before it is one of ours.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/material_deck.hpp"
#include "dashpad/model/pad/viscoelastic_foam.hpp"
#include "input/material_deck/deck_unit.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// The points as they stand, with the line of each.
struct DeckCurve {
  std::string name;      ///< "curve 12", "function 3", for messages
  std::size_t line = 0;  ///< where it begins
  std::vector<double> strain, stress;
  std::vector<std::size_t> lines;
};

struct DeckRateCurve {
  double rate = 0;       ///< 1/s; 0: not stated
  std::size_t line = 0;  ///< where the rate stands
  DeckCurve curve;
};

/// Air in closed cells that a crushed foam carries beside its skeleton: P0 e / (1 - e - phi).
struct DeckAir {
  double pressure = 0;
  double relative_density = 0;
};

struct DeckFoam {
  std::string card;  ///< "*MAT_083"
  std::string title;
  long id = 0;
  std::size_t line = 0;
  bool crushable = false;
  double density = 0;  ///< 0: not stated
  double modulus = 0;  ///< of the unloading of a crushable foam
  double unloading_factor = 1;
  double unloading_shape = 1;
  std::vector<DeckRateCurve> loading;
  std::optional<DeckCurve> unloading;
  DeckAir air;
  bool linear_in_rate = true;
  std::optional<ViscoelasticFoam> viscoelastic;  ///< the whole law; then there are no curves
  std::string basis = "solver card";
  std::string source;
  std::vector<std::string> assumptions, differences;
};

/// The foams of a text; what is wrong is told to `faults`.
std::vector<DeckFoam> read_ls_dyna(std::string_view text, const DeckUnits& units, MeasurementFaults& faults);
std::vector<DeckFoam> read_radioss(std::string_view text, const UnitSystem& system, const DeckUnits& units,
                                   MeasurementFaults& faults);

/// The material; absent after a fault.
std::optional<DeckMaterial> material_of(const DeckFoam& given, MeasurementFaults& faults);

/// A name for a file: letters, digits and hyphens of the title, else the number.
std::string name_for_card(const std::string& title, long id);

}  // namespace dashpad::input
