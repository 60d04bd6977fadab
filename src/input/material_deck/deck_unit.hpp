#pragma once
/// Numbers of decks in SI and back.
///
/// Where one unit is a power of ten of the other, only the exponent of the written number changes: a number
/// that is written and read again is the same to the last bit.

#include <optional>
#include <string>
#include <string_view>

#include "dashpad/quantities/unit_system.hpp"
#include "input/material_deck/deck_cards.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

struct DeckUnit {
  double factor = 1;                    ///< one unit in SI
  std::optional<int> power_of_ten = 0;  ///< of the factor, where it is one
};

/// Throws UnitError.
DeckUnit deck_unit(const std::string& unit, const std::string& si_unit);

struct DeckUnits {
  explicit DeckUnits(const UnitSystem& system);
  [[nodiscard]] const DeckUnit& of(Content content) const;

  DeckUnit none;
  DeckUnit stress;   ///< Pa
  DeckUnit density;  ///< kg/m3
  DeckUnit rate;     ///< 1/s
  DeckUnit time;     ///< s
};

/// The number in SI. As Fortran reads it: 1.5E-3, 1.5D-3 and 1.5-3 are one number.
ReadNumber read_deck_number(std::string_view text, const DeckUnit& unit);

/// The value in the unit of the deck, with as many digits as are needed to read it as the same number, or as
/// `width` columns hold.
std::string deck_number(double value, const DeckUnit& unit, std::size_t width);

}  // namespace dashpad::input
