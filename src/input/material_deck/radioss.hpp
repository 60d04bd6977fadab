#pragma once
/// Starter decks of Radioss: blocks, lines of a material, functions and laws.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// The blocks of a Radioss starter deck that are foams, functions or units.
struct RadiossBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks functions{"function"};
  std::map<long, std::vector<DeckBlock>>
      moves;                                    ///< /MOVE_FUNCT by the number of the function, in their order
  std::map<long, std::string> other_functions;  ///< keywords of functions that are not read
  NumberedBlocks units{"unit"};
  std::vector<DeckBlock> begins;  ///< each /BEGIN
  OutOfReach out_of_reach;
  std::unique_ptr<DeckParameters> parameters;  ///< those of /PARAMETER/GLOBAL
};
RadiossBlocks radioss_blocks(const DeckText& text, MeasurementFaults& faults);

/// The parts of a keyword: "MAT", "LAW90", "12"; and one of them as a number, 0 if it is none.
std::vector<std::string> parts_of(const DeckBlock& block);
long number_in(const std::vector<std::string>& parts, std::size_t place);

struct RadiossLaw {
  std::string_view number, words;
  bool crushable;
};
inline constexpr RadiossLaw radioss_laws[]{{"LAW33", "FOAM_PLAS", true},
                                           {"LAW62", "VISC_HYP", false},
                                           {"LAW70", "FOAM_TAB", false},
                                           {"LAW90", "LAW90", false}};
/// Null if the law is not read.
const RadiossLaw* radioss_law(std::string_view name);

struct RadiossSource {
  const RadiossBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};

/// The numbers of a line by field name, SI; NaN after a fault.
struct CardNumbers {
  DeckCard card;
  std::vector<double> values;
  std::size_t line = 0;

  /// Throws std::logic_error for a field that is not on the card.
  [[nodiscard]] double operator()(std::string_view field) const;
  /// The value of a valid whole number.
  [[nodiscard]] long whole(std::string_view field) const { return static_cast<long>((*this)(field)); }
  [[nodiscard]] bool are_sound() const;
};

/// The lines of one material after its title, taken in order.
class LawLines {
 public:
  LawLines(const DeckBlock& block, std::string name, const RadiossSource& from, DeckFoam& foam)
      : block_(block), name_(std::move(name)), from_(from), foam_(foam) {}

  /// The next line. Its absence is a fault.
  std::optional<DeckFields> next(const Widths& widths);
  /// The numbers of the next line. Reports fields that are set but have no counterpart here.
  std::optional<CardNumbers> next(DeckCard card);
  [[nodiscard]] bool at_end() const { return taken_ + 1 >= block_.lines.size(); }
  [[nodiscard]] std::string key(const std::string& field) const { return name_ + ": " + field; }

  /// The number of rows or terms in a field; absent if it is invalid.
  std::optional<long> count(const CardNumbers& card_numbers, const char* field, long fewest,
                            std::size_t most = max_rates);
  /// Reads `count` lines with function, rate and scale. False if one is missing or at fault.
  bool rows(long count, std::vector<DeckRateCurve>& rows);
  /// The points of a function, with stresses times `scale`, which is 1 if blank.
  std::optional<DeckCurve> function(long id, double scale, const char* field, std::size_t asked);

 private:
  const DeckBlock& block_;
  std::string name_;
  const RadiossSource& from_;
  DeckFoam& foam_;
  std::size_t taken_ = 0;
  bool told_ = false;
};

/// Readers of the laws, after the line of the density: crushable foam with closed cells (FOAM_PLAS), Ogden
/// with branches (VISC_HYP), tabulated foam (FOAM_TAB), the same with hysteresis. False after a fault.
bool read_law_33(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_62(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_70(LawLines& lines, const RadiossSource& from, DeckFoam& foam);
bool read_law_90(LawLines& lines, const RadiossSource& from, DeckFoam& foam);

}  // namespace dashpad::input
