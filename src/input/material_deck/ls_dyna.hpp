#pragma once
/// *KEYWORD input of LS-DYNA.

#include <memory>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// The blocks of *KEYWORD input that are foams, curves or tables.
struct LsDynaBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks curves{"curve"};
  NumberedBlocks tables{"table"};
  std::vector<std::string> other_materials;  ///< keywords of materials that are not read
  std::map<long, std::string> other_curves;  ///< keywords of curves that are not read, by number
  OutOfReach out_of_reach;
  std::unique_ptr<const DeckParameters> parameters;
};

/// The parameters of a deck: *PARAMETER and *PARAMETER_EXPRESSION with sums, products, powers, brackets and
/// the usual functions of parameters defined before. Anything else is a fault where it is used.
DeckParameters ls_dyna_parameters(std::string_view text, MeasurementFaults& faults);

LsDynaBlocks ls_dyna_blocks(std::string_view text, MeasurementFaults& faults);

/// The foam of a keyword such as MAT_083; null if it is not read.
const LsDynaFoam* ls_dyna_foam(std::string_view keyword);

/// The lines of a block without its title.
std::vector<DeckLine> lines_behind_title(const DeckBlock& block);
/// The title, UTF-8; may be empty.
std::string title_of(const DeckBlock& block);
std::string keyword_of(const DeckBlock& block);

/// A deck with the units of its numbers, and where faults go.
struct LsDynaSource {
  const LsDynaBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};
/// The curve with that number, scaled and shifted as its keyword says. If there is none, or it has a fault,
/// nothing, and a fault that names `key` and `asked`, the line that asks for it.
std::optional<DeckCurve> ls_dyna_curve(const LsDynaSource& from, long id, const std::string& key,
                                       std::size_t asked);
/// The table with that number, likewise.
std::optional<std::vector<DeckRateCurve>> ls_dyna_table(const LsDynaSource& from, long id,
                                                        const std::string& key, std::size_t asked);

}  // namespace dashpad::input
