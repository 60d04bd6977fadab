#pragma once
/// The keywords of a deck that matter here, with their lines.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/material_deck/deck_fields.hpp"
#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// Limits on what a file may ask for.
inline constexpr std::size_t most_foams_of_deck = 500;
inline constexpr std::size_t most_lines_of_curve = 10'000;

/// The blocks with a number, by it. A number that stands twice is a fault.
class NumberedBlocks {
 public:
  explicit NumberedBlocks(std::string kind) : kind_(std::move(kind)) {}

  void add(long id, DeckBlock block, MeasurementFaults& faults);
  [[nodiscard]] const DeckBlock* find(long id) const;
  [[nodiscard]] const DeckBlock* at_place(std::size_t place) const;

 private:
  std::string kind_;  ///< "curve", "function"
  std::map<long, DeckBlock> blocks_;
  std::map<std::size_t, long> places_;
};

/// The blocks of *KEYWORD input that are foams, curves or tables.
struct LsDynaBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks curves{"curve"};
  NumberedBlocks tables{"table"};
  std::vector<std::string> other_materials;  ///< keywords of materials that are not read
  bool includes_files = false;
};
LsDynaBlocks ls_dyna_blocks(std::string_view text, MeasurementFaults& faults);

/// The blocks of a Radioss starter deck that are foams, functions or units.
struct RadiossBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks functions{"function"};
  NumberedBlocks units{"unit"};
  std::optional<DeckBlock> begin;
  std::vector<std::string> other_materials;
  bool includes_files = false;
};
RadiossBlocks radioss_blocks(std::string_view text, MeasurementFaults& faults);
/// The parts of "MAT/LAW90/12/3" between its slashes.
std::vector<std::string> parts_of(const std::string& keyword);
/// A part of a keyword as a number; 0 where it is none.
long number_in(const std::vector<std::string>& parts, std::size_t place);

/// The lines of a block behind its title, if it has one.
std::vector<DeckLine> lines_behind_title(const DeckBlock& block);
/// The title, UTF-8; empty where the keyword has none.
std::string title_of(const DeckBlock& block);
/// The keyword without _TITLE.
std::string keyword_of(const DeckBlock& block);

/// The curve of that number, scaled and shifted as it says; absent after a fault, which names `key` and
/// `asked`, the line that asks for it.
std::optional<DeckCurve> ls_dyna_curve(const LsDynaBlocks& deck, long id, const std::string& key,
                                       std::size_t asked, const DeckUnits& units, MeasurementFaults& faults);
std::optional<std::vector<DeckRateCurve>> ls_dyna_table(const LsDynaBlocks& deck, long id,
                                                        const std::string& key, std::size_t asked,
                                                        const DeckUnits& units, MeasurementFaults& faults);

}  // namespace dashpad::input
