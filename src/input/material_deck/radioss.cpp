// The materials of a deck of Radioss: which are foams, in which units, and their lines.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/material_deck/radioss.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t columns_of_title = 100;

/// Whether the units that a line of the deck states, as codes or as numbers, are those of the system.
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
    if (!in_si.rule.empty()) return;  // no units after all
    if (std::abs(in_si.value / to_si("1 " + wanted[i][0], wanted[i][1]) - 1) < 1e-6) continue;
    faults.add(line.number, "units", to_utf8(stated),
               fmt::format("is not {}, as the unit system {} has it", wanted[i][0], system.name));
  }
}

/// A line with function, rate and scale.
std::optional<DeckRateCurve> row_of(LawLines& lines) {
  const auto row = lines.next(deck::function_row);
  if (!row || std::isnan((*row)("fct_ID")) || std::isnan((*row)("Fscale"))) return std::nullopt;
  auto curve = lines.function(row->whole("fct_ID"), (*row)("Fscale"), "fct_ID", row->line);
  if (!curve) return std::nullopt;
  return DeckRateCurve{(*row)("Eps_dot"), row->line, *std::move(curve)};
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
  if (!told_)
    from_.faults.add(block_.head.number, name_, "",
                     fmt::format("ends after {} {}", taken_, taken_ == 1 ? "line" : "lines"));
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

std::optional<long> LawLines::count(const CardNumbers& of, const char* field, long fewest, std::size_t most) {
  const double count = of(field);
  if (std::isnan(count)) return std::nullopt;
  if (count >= static_cast<double>(fewest) && count <= static_cast<double>(most)) return of.whole(field);
  from_.faults.add(of.line, key(field), fmt::format("{}", of.whole(field)),
                   fmt::format("must be between {} and {}", fewest, most));
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
        fmt::format(
            "there is no /FUNCT/{}{}", id,
            from_.deck.includes_files ? "; files of #include are not read: put it into this deck" : ""));
    return std::nullopt;
  }
  DeckCurve curve{fmt::format("function {}", id), block->head.number, {}, {}, {}};
  if (block->lines.size() > most_lines_of_curve) {
    from_.faults.add(curve.line, curve.name, "", too_many_points(block->lines.size() - 1));
    return std::nullopt;
  }
  if (scale == 0) scale = 1;
  for (std::size_t i = 1; i < block->lines.size(); ++i) {
    DeckFields point(block->lines[i], {20, 20}, false, from_.faults);
    curve.strain.push_back(point.number(0, curve.name + ": X" + std::to_string(i)));
    const double stress = point.number(1, curve.name + ": Y" + std::to_string(i), from_.units.stress);
    curve.stress.push_back(scale == 1 ? stress : scale * stress);
    curve.lines.push_back(point.line());
  }
  return curve;
}

std::vector<DeckFoam> read_radioss(std::string_view text, const UnitSystem& system, const DeckUnits& units,
                                   MeasurementFaults& faults) {
  const RadiossBlocks blocks = radioss_blocks(text, faults);
  if (blocks.begin && blocks.begin->lines.size() > 2) compare_units(blocks.begin->lines[2], system, faults);
  if (blocks.foams.empty())
    faults.add(0, "", "",
               "holds no /MAT/LAW33 (FOAM_PLAS), /MAT/LAW62 (VISC_HYP), /MAT/LAW70 (FOAM_TAB) or /MAT/LAW90" +
                   others_listed(blocks.other_materials));
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : blocks.foams) {
    const std::vector<std::string> parts = parts_of(block.keyword);
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
