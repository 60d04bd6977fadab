#pragma once
/// The units in which a deck states that its numbers are, and those in which they are read.

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/quantities/unit_system.hpp"
#include "input/material_deck/deck_cards.hpp"
#include "input/material_deck/deck_includes.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

struct StatedUnits {
  std::size_t line = 0;                ///< 0: nothing is stated
  std::string words = {};              ///< "kg, mm, ms", as written
  const UnitSystem* system = nullptr;  ///< null if it is none of those that are read
  std::string unknown = {};            ///< "XX is not a unit of mass": why the words state nothing; else ""
};

/// Units of mass, length and time, each by a name such as Mg or as a number of kg, m or s. Three times 1,
/// which programs write where nobody chose units, and a blank state nothing.
StatedUnits stated_units(std::size_t line, const std::array<std::string_view, 3>& units);

/// The same by the words of *CONTROL_UNITS, such as micro_s and mtrc_ton; blank is kg, m or s, unless all
/// are.
StatedUnits units_by_words(std::size_t line, const std::array<std::string_view, 3>& words);

/// The units of numbers, and how they came about: "t-mm-s", "t-mm-s, as the deck states on line 4".
struct ChosenUnits {
  DeckUnits units;
  std::string words;
};

/// Chooses between the units that the user gives and those that the deck states, which must agree.
class UnitChoice {
 public:
  UnitChoice(const std::optional<UnitSystem>& given, const DeckText& deck, MeasurementFaults& faults)
      : given_(given), deck_(deck), faults_(faults) {}

  /// The statement in which those of a deck agree. Absent after a fault, if two contradict each other.
  std::optional<StatedUnits> agreed(const std::vector<StatedUnits>& statements);
  /// The units of numbers to which a statement applies. Absent after a fault; each statement causes only one.
  std::optional<ChosenUnits> for_numbers(const StatedUnits& stated);
  [[nodiscard]] bool are_given() const { return given_.has_value(); }

 private:
  [[nodiscard]] std::string rule_for(const StatedUnits& stated) const;

  const std::optional<UnitSystem>& given_;
  const DeckText& deck_;
  MeasurementFaults& faults_;
  std::set<std::size_t> told_;  ///< lines of statements that had their fault
};

}  // namespace dashpad::input
