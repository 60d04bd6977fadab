#pragma once
/// *KEYWORD input of LS-DYNA.

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// The parameters that each file of a deck knows: those of *PARAMETER_LOCAL in it and in the files that
/// include it, and the others of the whole deck.
class LsDynaScopes {
 public:
  explicit LsDynaScopes(const DeckText& deck);

  [[nodiscard]] const DeckParameters& of(std::size_t file) const { return scopes_[file + 1]; }
  DeckParameters& local_to(std::size_t file) { return scopes_[file + 1]; }
  DeckParameters& of_all() { return scopes_.front(); }

 private:
  std::deque<DeckParameters> scopes_;  ///< of the whole deck, then of each file; they refer to one another
};

/// Reads *PARAMETER and *PARAMETER_EXPRESSION, with the options LOCAL and MUTABLE: sums, products, powers,
/// brackets and the usual functions of parameters defined before.
void read_ls_dyna_parameters(const DeckText& deck, LsDynaScopes& scopes, MeasurementFaults& faults);

/// The blocks of *KEYWORD input that are foams, curves, tables or units.
struct LsDynaBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks curves{"curve"};
  NumberedBlocks tables{"table"};
  std::vector<DeckBlock> units;              ///< each *CONTROL_UNITS
  std::map<long, std::string> other_curves;  ///< keywords of curves that are not read, by number
  OutOfReach out_of_reach;
  std::unique_ptr<LsDynaScopes> parameters;
};

LsDynaBlocks ls_dyna_blocks(const DeckText& text, MeasurementFaults& faults);

/// The block that a line such as "*MAT_057_TITLE +" begins, and whether its fields are long.
DeckBlock begun_block(const DeckLine& line, bool all_long);
/// Whether *KEYWORD makes all fields long.
bool says_long(std::string_view head);

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
