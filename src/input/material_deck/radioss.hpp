#pragma once
/// A starter deck of Radioss: its blocks, the lines of a material, the functions that it names, and its laws.

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// The blocks of a Radioss starter deck that are foams, functions or units.
struct RadiossBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks functions{"function"};
  NumberedBlocks units{"unit"};
  std::optional<DeckBlock> begin;
  std::vector<std::string> other_materials;
  bool includes_files = false;
};
struct RadiossSource {
  const RadiossBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};

/// The numbers of a line by the names of its fields, SI; NaN after a fault.
struct CardNumbers {
  DeckCard card;
  std::vector<double> values;
  std::size_t line = 0;

  /// Throws std::logic_error for a field that the card has not.
  [[nodiscard]] double operator()(std::string_view field) const;
  /// Of a whole number that is sound.
  [[nodiscard]] long whole(std::string_view field) const { return static_cast<long>((*this)(field)); }
  [[nodiscard]] bool are_sound() const;
};

/// The lines of one material behind its title, taken one after the other.
class LawLines {
 public:
  LawLines(const DeckBlock& block, std::string name, const RadiossSource& from, DeckFoam& foam)
      : block_(block), name_(std::move(name)), from_(from), foam_(foam) {}

  /// Absent at the end, which is a fault.
  std::optional<DeckFields> next(const Widths& widths);
  /// The numbers of the next line; says what those that have no counterpart here mean. Absent at the end.
  std::optional<CardNumbers> next(DeckCard card);
  [[nodiscard]] bool at_end() const { return taken_ + 1 >= block_.lines.size(); }
  [[nodiscard]] std::string key(const std::string& field) const { return name_ + ": " + field; }

  /// The number of rows or terms in a field; absent where it is none that can be.
  std::optional<long> count(const CardNumbers& card_numbers, const char* field, long fewest,
                            std::size_t most = max_rates);
  /// So many lines with function, rate and scale; false where one is missing or at fault.
  bool rows(long count, std::vector<DeckRateCurve>& rows);
  /// The points of a function, stresses times `scale`, which is 1 where it is blank.
  std::optional<DeckCurve> function(long id, double scale, const char* field, std::size_t asked);

 private:
  const DeckBlock& block_;
  std::string name_;
  const RadiossSource& from_;
  DeckFoam& foam_;
  std::size_t taken_ = 0;
  bool told_ = false;
};

/// The foams of Radioss behind the line of their density: crushable foam with closed cells (FOAM_PLAS), Ogden
/// with branches (VISC_HYP), tabulated foam (FOAM_TAB) and tabulated foam with a loss of energy. False where
/// a line is missing or at fault.
bool read_law_33(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_62(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_70(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_90(LawLines& lines, const RadiossSource& from, DeckFoam& foam);

}  // namespace dashpad::input
