// Starter decks of Radioss: "/" in the first column begins a block, "#" a comment. Finds the foams, their
// units and their lines.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/material_deck/radioss.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t columns_of_title = 100;

struct RadiossLaw {
  std::string_view number, words;
  bool crushable;
  bool (*read)(LawLines&, const RadiossSource&, DeckFoam&);
};
inline constexpr RadiossLaw radioss_laws[]{{"LAW33", "FOAM_PLAS", true, read_law_33},
                                           {"LAW62", "VISC_HYP", false, read_law_62},
                                           {"LAW70", "FOAM_TAB", false, read_law_70},
                                           {"LAW90", "LAW90", false, read_law_90}};

/// Null if the law is not read.
const RadiossLaw* radioss_law(std::string_view name) {
  const auto* const found = std::ranges::find_if(
      radioss_laws, [&](const RadiossLaw& each) { return name == each.number || name == each.words; });
  return found == std::end(radioss_laws) ? nullptr : found;
}

/// A part of a keyword as a number, or 0.
long number_in(const std::vector<std::string>& parts, std::size_t place) {
  if (place >= parts.size()) return 0;
  const ReadNumber read = read_deck_number(parts[place], {});
  const bool is_number = read.kind == NumberKind::number && read.value > 0 && read.value < 1e10;
  return is_number ? static_cast<long>(read.value) : 0;
}

/// Checks that the units in a line, given as codes or as numbers, are those of the system.
void compare_units(const DeckLine& line, const UnitSystem& system, MeasurementFaults& faults) {
  const std::array<std::array<std::string, 2>, 3> wanted{
      {{system.mass, "kg"}, {system.length, "m"}, {system.time, "s"}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (line.text.size() <= 20 * i) return;
    const std::string stated(without_blanks(line.text.substr(20 * i, 20)));
    if (stated.empty()) return;
    const ReadNumber number = read_deck_number(stated, {});
    SiValue in_si{number.value, ""};
    if (number.kind != NumberKind::number) in_si = read_si("1 " + stated, wanted[i][1]);
    if (!in_si.rule.empty()) return;  // not a line of units
    if (std::abs(in_si.value / to_si("1 " + wanted[i][0], wanted[i][1]) - 1) < 1e-6) continue;
    faults.add(line.number, "units", to_utf8(stated),
               fmt::format("must be {}, as in the unit system {}", wanted[i][0], system.name));
  }
}

std::optional<DeckRateCurve> row_of(LawLines& lines) {
  const auto row = lines.next(deck::function_row);
  if (!row || std::isnan((*row)("fct_ID")) || std::isnan((*row)("Fscale"))) return std::nullopt;
  auto curve = lines.function(row->whole("fct_ID"), (*row)("Fscale"), "fct_ID", row->line);
  if (!curve) return std::nullopt;
  return DeckRateCurve{(*row)("Eps_dot"), row->line, *std::move(curve)};
}

constexpr std::size_t max_laws_listed = 10;

void take(DeckBlock block, RadiossBlocks& deck, MeasurementFaults& faults) {
  const std::vector<std::string> parts = split_at(block.keyword, '/');
  while (!block.lines.empty() && without_blanks(block.lines.back().text).empty()) block.lines.pop_back();
  const bool material = parts.size() > 2 && parts[0] == "MAT";
  if (material && radioss_law(parts[1]) != nullptr) {
    if (deck.foams.size() == max_foams_of_deck)
      faults.refuse(block.head.number, "", "", fmt::format("has more than {} foams", max_foams_of_deck));
    deck.foams.push_back(std::move(block));
  } else if (material) {
    if (deck.other_materials.size() < max_laws_listed)
      deck.other_materials.push_back(to_utf8("/MAT/" + parts[1]));
  } else if (parts[0] == "FUNCT" && number_in(parts, 1) != 0) {
    deck.functions.add(number_in(parts, 1), std::move(block), faults);
  } else if (parts[0] == "UNIT" && number_in(parts, 1) != 0) {
    deck.units.add(number_in(parts, 1), std::move(block), faults);
  } else if (parts[0] == "BEGIN" && !deck.begin) {
    deck.begin = std::move(block);
  }
}

RadiossBlocks radioss_blocks(std::string_view text, MeasurementFaults& faults) {
  RadiossBlocks deck;
  LineReader lines(text);
  std::string_view line;
  DeckBlock block;
  bool wanted = false;  // whether the block is kept
  const auto finish = [&] {
    if (wanted) take(std::exchange(block, {}), deck, faults);
    wanted = false;
  };
  while (lines.next(line)) {
    if (line.starts_with("#include")) deck.includes_files = true;
    if (line.starts_with('#') || line.starts_with('$')) continue;
    if (!line.starts_with('/')) {
      if (wanted) block.lines.push_back({lines.number(), line});
      continue;
    }
    finish();
    block.keyword = upper_case(without_blanks(line.substr(1, line.find_first_of(" \t") - 1)));
    block.head = {lines.number(), line};
    if (block.keyword == "END") break;
    wanted = block.keyword.starts_with("MAT/") || block.keyword.starts_with("FUNCT/") ||
             block.keyword.starts_with("UNIT/") || block.keyword == "BEGIN";
  }
  finish();
  return deck;
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
    from_.faults.add(
        asked, key(field), fmt::format("{}", id),
        missing(fmt::format("/FUNCT/{}", id), {.includes_files = from_.deck.includes_files}, "#include"));
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
    curve.add(strain, scale == 1 ? stress : scale * stress, point.line());
  }
  return curve;
}

std::vector<DeckFoam> read_radioss(std::string_view text, const UnitSystem& system, const DeckUnits& units,
                                   MeasurementFaults& faults) {
  const RadiossBlocks blocks = radioss_blocks(text, faults);
  if (blocks.begin && blocks.begin->lines.size() > 2) compare_units(blocks.begin->lines[2], system, faults);
  if (blocks.foams.empty())
    faults.add(
        0, "", "",
        "contains no /MAT/LAW33 (FOAM_PLAS), /MAT/LAW62 (VISC_HYP), /MAT/LAW70 (FOAM_TAB) or /MAT/LAW90" +
            others_listed(blocks.other_materials));
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : blocks.foams) {
    const std::vector<std::string> parts = split_at(block.keyword, '/');
    const RadiossLaw& law = *radioss_law(parts[1]);
    DeckFoam foam;
    foam.card = fmt::format("/MAT/{}", law.number);
    foam.id = number_in(parts, 2);
    foam.line = block.head.number;
    foam.crushable = law.crushable;
    if (!block.lines.empty())
      foam.title = to_utf8(without_blanks(block.lines.front().text.substr(0, columns_of_title)));
    if (const DeckBlock* const own = blocks.units.find(number_in(parts, 3));
        own != nullptr && own->lines.size() > 1)
      compare_units(own->lines[1], system, faults);
    const RadiossSource from{blocks, units, faults};
    LawLines lines(block, foam.card, from, foam);
    const auto density = lines.next(deck::density_line);
    if (!density) continue;
    foam.density = (*density)("RHO_I");
    if (law.read(lines, from, foam)) foams.push_back(std::move(foam));
  }
  return foams;
}

}  // namespace dashpad::input
