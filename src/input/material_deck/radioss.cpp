// Foams of Radioss starter decks: the lines of a material, its functions and its units.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "input/material_deck/radioss.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t columns_of_title = 100;

std::optional<DeckRateCurve> row_of(LawLines& lines) {
  const auto row = lines.next(deck::function_row);
  if (!row || std::isnan((*row)("fct_ID")) || std::isnan((*row)("Fscale"))) return std::nullopt;
  auto curve = lines.function(row->whole("fct_ID"), (*row)("Fscale"), "fct_ID", row->line);
  if (!curve) return std::nullopt;
  return DeckRateCurve{(*row)("Eps_dot"), row->line, *std::move(curve)};
}

/// Scales and shifts a function as a /MOVE_FUNCT says. False after a fault.
bool apply_move(DeckCurve& curve, const DeckBlock& block, const RadiossSource& from) {
  if (block.lines.size() < 2) return true;
  DeckFields numbers(block.lines[1], {20, 20, 20, 20}, false, from.faults);
  const std::string key = "move of " + curve.name;
  double scale_x = numbers.number(0, key + ": Ascalex"), scale_y = numbers.number(1, key + ": Fscaley");
  const double shift_x = numbers.number(2, key + ": Ashiftx");
  const double shift_y = numbers.number(3, key + ": Fshifty", from.units.stress);
  if (std::isnan(scale_x + scale_y + shift_x + shift_y)) return false;
  if (scale_x == 0) scale_x = 1;
  if (scale_y == 0) scale_y = 1;
  for (double& x : curve.strain) x = x * scale_x + shift_x;
  for (double& y : curve.stress) y = y * scale_y + shift_y;
  if (scale_x < 0) curve.reverse();
  return true;
}

StatedUnits units_in_line(const DeckBlock& block, std::size_t place) {
  if (place >= block.lines.size()) return {};
  const DeckLine& line = block.lines[place];
  const auto field = [&](std::size_t i) {
    return without_blanks(line.text.substr(std::min(20 * i, line.text.size()), 20));
  };
  return stated_units(line.number, {field(0), field(1), field(2)});
}

/// What a /BEGIN states in its first line of units, that of the input, which may be blank as the second.
StatedUnits units_of_begin(const DeckBlock& begin) {
  const bool is_blank = begin.lines.size() > 2 && without_blanks(begin.lines[2].text).empty();
  return units_in_line(begin, is_blank ? 3 : 2);
}

/// What the deck says about the units of a material: its own /UNIT or else /BEGIN. Absent after a fault.
std::optional<StatedUnits> units_of_material(const DeckBlock& material, const RadiossBlocks& deck,
                                             UnitChoice& units) {
  if (const long own = number_in(parts_of(material), 3); own != 0) {
    const DeckBlock* const block = deck.units.find(own);
    return block == nullptr ? StatedUnits{} : units_in_line(*block, 1);
  }
  std::vector<StatedUnits> statements;
  for (const DeckBlock& begin : deck.begins) statements.push_back(units_of_begin(begin));
  return units.agreed(statements);
}

/// Whether the units of a material are there, if it has its own and they are to be taken from the deck.
bool has_its_units(const DeckBlock& material, const std::string& card, const RadiossBlocks& deck,
                   const UnitChoice& units, MeasurementFaults& faults) {
  const long own = number_in(parts_of(material), 3);
  if (own == 0 || units.are_given() || deck.units.find(own) != nullptr) return true;
  faults.add(material.head.number, card + ": unit", fmt::format("{}", own),
             missing(fmt::format("/UNIT/{}", own), deck.out_of_reach));
  return false;
}

bool read_law(std::string_view number, LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  if (number == "LAW33") return read_law_33(lines, from, foam);
  if (number == "LAW62") return read_law_62(lines, from, foam);
  return number == "LAW70" ? read_law_70(lines, from, foam) : read_law_90(lines, from, foam);
}

/// Absent after a fault.
std::optional<DeckFoam> foam_of(const DeckBlock& block, const RadiossBlocks& deck, UnitChoice& units,
                                MeasurementFaults& faults) {
  const std::vector<std::string> parts = parts_of(block);
  const RadiossLaw& law = *radioss_law(parts[1]);
  DeckFoam foam;
  foam.card = fmt::format("/MAT/{}", law.number);
  foam.id = number_in(parts, 2);
  foam.line = block.head.number;
  foam.crushable = law.crushable;
  if (!block.lines.empty())
    foam.title = to_utf8(without_blanks(block.lines.front().text.substr(0, columns_of_title)));
  if (!has_its_units(block, foam.card, deck, units, faults)) return std::nullopt;
  const auto stated = units_of_material(block, deck, units);
  const auto chosen = stated ? units.for_numbers(*stated) : std::nullopt;
  if (!chosen) return std::nullopt;
  foam.units = chosen->words;
  const RadiossSource from{deck, chosen->units, faults};
  LawLines lines(block, foam.card, from, foam);
  const auto density = lines.next(deck::density_line);
  if (!density) return std::nullopt;
  foam.density = (*density)("RHO_I");
  return read_law(law.number, lines, from, foam) ? std::optional(std::move(foam)) : std::nullopt;
}

}  // namespace

double CardNumbers::operator()(std::string_view field) const {
  const auto found = std::ranges::find(card, field, &DeckField::name);
  if (found == card.end()) throw std::logic_error("no field " + std::string(field));
  return values[static_cast<std::size_t>(found - card.begin())];
}

bool CardNumbers::are_sound() const {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (card[i].is_read() && std::isnan(values[i])) return false;
  return true;
}

std::optional<DeckFields> LawLines::next(const Widths& widths) {
  if (taken_ + 1 < block_.lines.size())
    return DeckFields(block_.lines[++taken_], widths, false, from_.faults);
  if (!told_) from_.faults.add(block_.head.number, name_, "", "ends after only " + plural(taken_, "line"));
  told_ = true;
  return std::nullopt;
}

std::optional<CardNumbers> LawLines::next(DeckCard card) {
  Widths widths;
  for (const DeckField& field : card) widths.push_back(field.width);
  auto line = next(widths);
  if (!line) return std::nullopt;
  CardNumbers numbers{card, {}, line->line()};
  for (std::size_t i = 0; i < card.size(); ++i) {
    const DeckField& field = card[i];
    double value = no_value;
    if (field.is_read() && field.content == Content::whole) {
      if (const auto whole = line->whole(i, key(field.name))) value = static_cast<double>(*whole);
    } else if (field.is_read()) {
      value = line->number(i, key(field.name), from_.units.of(field.content));
    } else if (field.matters()) {
      tell_if_set(line->number(i, key(field.name)), field, foam_);
    }
    numbers.values.push_back(value);
  }
  return numbers;
}

std::optional<long> LawLines::count(const CardNumbers& card_numbers, const char* field, long fewest,
                                    std::size_t most) {
  const double count = card_numbers(field);
  if (std::isnan(count)) return std::nullopt;
  if (count >= static_cast<double>(fewest) && count <= static_cast<double>(most))
    return card_numbers.whole(field);
  from_.faults.add(card_numbers.line, key(field), fmt::format("{}", card_numbers.whole(field)),
                   fmt::format("must be from {} to {}", fewest, most));
  return std::nullopt;
}

bool LawLines::rows(long count, std::vector<DeckRateCurve>& rows) {
  bool sound = true;
  for (long i = 0; i < count; ++i) {
    auto row = row_of(*this);
    sound = sound && row;
    if (row) rows.push_back(*std::move(row));
  }
  return sound;
}

std::optional<DeckCurve> LawLines::function(long id, double scale, const char* field, std::size_t asked) {
  const DeckBlock* const block = from_.deck.functions.find(id);
  if (block == nullptr) {
    const auto other = from_.deck.other_functions.find(id);
    from_.faults.add(asked, key(field), fmt::format("{}", id),
                     other != from_.deck.other_functions.end()
                         ? fmt::format("function {} is a {}; only /FUNCT is read", id, other->second)
                         : missing(fmt::format("/FUNCT/{}", id), from_.deck.out_of_reach));
    return std::nullopt;
  }
  DeckCurve curve{fmt::format("function {}", id), block->head.number};
  if (block->lines.size() > max_lines_of_curve) {
    from_.faults.add(curve.line, curve.name, "", too_many_points(block->lines.size() - 1));
    return std::nullopt;
  }
  if (scale == 0) scale = 1;
  for (std::size_t i = 1; i < block->lines.size(); ++i) {
    DeckFields point(block->lines[i], {20, 20}, false, from_.faults);
    const double strain = point.number(0, curve.name + ": X" + std::to_string(i));
    const double stress = point.number(1, curve.name + ": Y" + std::to_string(i), from_.units.stress);
    curve.add(strain, stress, point.line());
  }
  if (const auto moves = from_.deck.moves.find(id); moves != from_.deck.moves.end()) {
    for (const DeckBlock& each : moves->second)
      if (!apply_move(curve, each, from_)) return std::nullopt;
    curve.name += fmt::format(" after /MOVE_FUNCT/{}", id);
    curve.is_moved = true;
  }
  for (double& stress : curve.stress) stress *= scale;
  return curve;
}

std::vector<DeckFoam> read_radioss(const DeckText& text, UnitChoice& units, MeasurementFaults& faults) {
  const RadiossBlocks deck = radioss_blocks(text, faults);
  if (deck.foams.empty())
    faults.add(
        0, "", "",
        contains_no("/MAT/LAW33 (FOAM_PLAS), /MAT/LAW62 (VISC_HYP), /MAT/LAW70 (FOAM_TAB) or /MAT/LAW90",
                    deck.out_of_reach));
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : deck.foams)
    if (auto foam = foam_of(block, deck, units, faults)) foams.push_back(*std::move(foam));
  return foams;
}

}  // namespace dashpad::input
