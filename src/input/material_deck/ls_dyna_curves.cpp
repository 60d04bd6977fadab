// *DEFINE_CURVE and *DEFINE_TABLE.

#include <cmath>

#include <fmt/format.h>

#include "input/material_deck/deck_blocks.hpp"

namespace dashpad::input {

namespace {

const std::vector<std::size_t> pair_of_twenty{20, 20};

/// Scale and offset of an axis: scale (value + offset).
struct Shift {
  double scale = 1;
  double offset = 0;

  /// What was read stays as it is where nothing is to be done.
  [[nodiscard]] double of(double value) const {
    return scale == 1 && offset == 0 ? value : scale * (value + offset);
  }
};

Shift read_shift(DeckFields& fields, std::size_t scale_field, std::size_t offset_field,
                 const char* const keys[2], const DeckUnit& unit = {}) {
  Shift shift{fields.number(scale_field, keys[0]), fields.number(offset_field, keys[1], unit)};
  if (shift.scale == 0) shift.scale = 1;
  return shift;
}

std::string missing(const LsDynaBlocks& deck, const char* keyword, long id) {
  return fmt::format("there is no {} {}{}", keyword, id,
                     deck.includes_files ? "; files of *INCLUDE are not read: put it into this deck" : "");
}

}  // namespace

std::optional<DeckCurve> ls_dyna_curve(const LsDynaBlocks& deck, long id, const std::string& key,
                                       std::size_t asked, const DeckUnits& units, MeasurementFaults& faults) {
  const DeckBlock* const block = deck.curves.find(id);
  if (block == nullptr) {
    faults.add(asked, key, fmt::format("{}", id), missing(deck, "*DEFINE_CURVE", id));
    return std::nullopt;
  }
  const std::vector<DeckLine> lines = lines_behind_title(*block);
  if (lines.size() > most_lines_of_curve) {
    faults.add(block->head.number, fmt::format("curve {}", id), "",
               fmt::format("has {} points; {} are the most", lines.size() - 1, TableCurve::most_points));
    return std::nullopt;
  }
  DeckFields head(lines.front(), equal_widths(8, block->long_format), true, faults);
  constexpr const char* keys_of_strain[]{"SFA", "OFFA"};
  constexpr const char* keys_of_stress[]{"SFO", "OFFO"};
  const Shift of_strain = read_shift(head, 2, 4, keys_of_strain);
  const Shift of_stress = read_shift(head, 3, 5, keys_of_stress, units.stress);
  DeckCurve curve{fmt::format("curve {}", id), block->head.number, {}, {}, {}};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    DeckFields point(lines[i], pair_of_twenty, true, faults);
    const double strain = point.number(0, curve.name + ": A" + std::to_string(i));
    const double stress = point.number(1, curve.name + ": O" + std::to_string(i), units.stress);
    curve.strain.push_back(of_strain.of(strain));
    curve.stress.push_back(of_stress.of(stress));
    curve.lines.push_back(lines[i].number);
    if (std::isinf(curve.strain.back()) || std::isinf(curve.stress.back())) {
      faults.add(lines[i].number, curve.name, "", "is too large a number once it is scaled");
      return std::nullopt;
    }
  }
  return curve;
}

std::optional<std::vector<DeckRateCurve>> ls_dyna_table(const LsDynaBlocks& deck, long id,
                                                        const std::string& key, std::size_t asked,
                                                        const DeckUnits& units, MeasurementFaults& faults) {
  const DeckBlock* const block = deck.tables.find(id);
  if (block == nullptr) {
    faults.add(asked, key, fmt::format("{}", id),
               deck.curves.find(id) != nullptr ? "is a curve; a table of curves over rates is needed"
                                               : missing(deck, "*DEFINE_TABLE", id));
    return std::nullopt;
  }
  const std::vector<DeckLine> lines = lines_behind_title(*block);
  const std::string name = fmt::format("table {}", id);
  DeckFields head(lines.front(), equal_widths(3, block->long_format), true, faults);
  constexpr const char* keys_of_rate[]{"SFA", "OFFA"};
  const Shift of_rate = read_shift(head, 1, 2, keys_of_rate, units.rate);
  if (lines.size() < 2 || lines.size() > most_rates + 1) {
    faults.add(block->head.number, name, "",
               fmt::format("has {} rates; must have between 1 and {}", lines.size() - 1, most_rates));
    return std::nullopt;
  }
  std::vector<DeckRateCurve> rows;
  bool sound = true;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    DeckFields row(lines[i], pair_of_twenty, true, faults);
    DeckRateCurve at{of_rate.of(row.number(0, name + ": rate", units.rate)), lines[i].number, {}};
    std::optional<DeckCurve> curve;
    if (!row.is_blank(1)) {
      if (const auto named = row.whole(1, name + ": LCID"))
        curve = ls_dyna_curve(deck, *named, name + ": LCID", lines[i].number, units, faults);
    } else if (keyword_of(*block) == "DEFINE_TABLE_2D") {
      faults.add(lines[i].number, name, "", "needs the number of a curve behind the rate (columns 21 to 40)");
    } else {
      // The classic kind: as many *DEFINE_CURVE follow at once, in the order of the rates.
      long following = 0;
      if (const DeckBlock* const next = deck.curves.at_place(block->place + i)) {
        const std::vector<DeckLine> lines_of_next = lines_behind_title(*next);
        DeckFields first(lines_of_next.front(), equal_widths(1, next->long_format), true, faults);
        following = first.whole(0, "LCID").value_or(0);
        curve = ls_dyna_curve(deck, following, name, lines[i].number, units, faults);
      } else {
        faults.add(lines[i].number, name, "",
                   fmt::format("has {} rates, so {} *DEFINE_CURVE must follow it at once; number {} does not",
                               lines.size() - 1, lines.size() - 1, i));
      }
    }
    sound = sound && curve;
    if (!curve) continue;
    at.curve = *std::move(curve);
    rows.push_back(std::move(at));
  }
  return sound ? std::optional(std::move(rows)) : std::nullopt;
}

}  // namespace dashpad::input
