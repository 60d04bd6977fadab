// Blocks of *KEYWORD input: "*" in the first column begins a keyword, "$" a comment. Curves and tables.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/ls_dyna.hpp"

namespace dashpad::input {
namespace {

constexpr std::string_view begin_of_encrypted = "-----BEGIN PGP", end_of_encrypted = "-----END PGP";

/// The number in the first field; absent if there is none, since unused curves may be anything.
std::optional<long> number_of_block(const DeckBlock& block) {
  const std::vector<DeckLine> lines = lines_behind_title(block);
  if (lines.empty()) return std::nullopt;
  const std::string_view line = lines.front().text;
  const auto comma = line.find(',');
  const std::size_t width = comma != std::string_view::npos ? comma : block.long_format ? 20 : 10;
  const std::string_view field = without_blanks(line.substr(0, width));
  ReadNumber read = read_deck_number(field, {});
  if (const auto use = parameter_use(field, *lines.front().parameters); use && use->rule.empty())
    read = {NumberKind::number, use->value};
  if (read.kind != NumberKind::number || !(std::abs(read.value) < 1e10)) return std::nullopt;
  return static_cast<long>(read.value);
}

const Widths pair_of_twenty{20, 20};

/// Scale and offset of an axis: scale (value + offset).
struct Shift {
  double scale = 1;
  double offset = 0;

  /// Leaves numbers exactly as read if there is nothing to do.
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

}  // namespace

std::vector<DeckLine> lines_behind_title(const DeckBlock& block) {
  const bool has_title = block.keyword.find("_TITLE") != std::string::npos && !block.lines.empty();
  return {block.lines.begin() + (has_title ? 1 : 0), block.lines.end()};
}

std::string title_of(const DeckBlock& block) {
  if (block.keyword.find("_TITLE") == std::string::npos || block.lines.empty()) return "";
  return to_utf8(without_blanks(block.lines.front().text.substr(0, 80)));
}

std::string keyword_of(const DeckBlock& block) {
  std::string keyword = block.keyword;
  if (const auto at = keyword.find("_TITLE"); at != std::string::npos) keyword.erase(at, 6);
  return keyword;
}

const LsDynaFoam* ls_dyna_foam(std::string_view keyword) {
  if (!keyword.starts_with("MAT_")) return nullptr;
  const std::string_view rest = keyword.substr(4);
  const auto is_called = [&](std::string_view name) {
    return rest.starts_with(name) && (rest.size() == name.size() || rest[name.size()] == '_');
  };
  const auto* const found = std::ranges::find_if(
      ls_dyna_foams, [&](const LsDynaFoam& each) { return is_called(each.words) || is_called(each.number); });
  return found == std::end(ls_dyna_foams) ? nullptr : found;
}

DeckBlock begun_block(const DeckLine& line, bool all_long) {
  DeckBlock block;
  block.head = line;
  block.long_format = all_long;
  std::string text = upper_case(line.text.substr(1));
  const auto end = text.find_first_of(" \t,");
  std::string options = end == std::string::npos ? "" : text.substr(end);
  block.keyword = text.substr(0, end);
  if (block.keyword.ends_with('+') || block.keyword.ends_with('-')) {
    options += block.keyword.back();
    block.keyword.pop_back();
  }
  if (options.find('+') != std::string::npos) block.long_format = true;
  if (options.find('-') != std::string::npos) block.long_format = false;
  return block;
}

bool says_long(std::string_view head) {
  const std::string text = upper_case(head);
  const auto at = text.find("LONG=");
  return at != std::string::npos && text.substr(at + 5, 1) != "S";
}

namespace {

enum class BlockKind { foam, curve, other_curve, table, units, unread };

BlockKind kind_of_block(const std::string& keyword) {
  if (ls_dyna_foam(keyword) != nullptr) return BlockKind::foam;
  if (keyword == "DEFINE_CURVE") return BlockKind::curve;
  if (keyword.starts_with("DEFINE_CURVE") || keyword.starts_with("DEFINE_FUNCTION"))
    return BlockKind::other_curve;
  if (keyword == "DEFINE_TABLE" || keyword == "DEFINE_TABLE_2D") return BlockKind::table;
  return keyword == "CONTROL_UNITS" || keyword == "CONTROL_UNIT" ? BlockKind::units : BlockKind::unread;
}

void note_unread(const std::string& keyword, OutOfReach& out_of_reach) {
  if (keyword.starts_with("MAT_"))
    out_of_reach.add_material("*" + keyword);
  else if (keyword == "INCLUDE")
    out_of_reach.include = "*INCLUDE";
  else if (keyword.starts_with("INCLUDE") && !keyword.starts_with("INCLUDE_PATH"))
    out_of_reach.other_include = "*" + to_utf8(keyword);
}

void keep_ls_dyna_block(DeckBlock block, BlockKind kind, const DeckText& text, LsDynaBlocks& deck,
                        MeasurementFaults& faults) {
  if (kind == BlockKind::foam) {
    if (deck.foams.size() == max_foams_of_deck)
      faults.refuse(block.head.number, "", "", fmt::format("has more than {} foams", max_foams_of_deck));
    deck.foams.push_back(std::move(block));
  } else if (kind == BlockKind::units) {
    deck.units.push_back(std::move(block));
  } else if (const auto id = number_of_block(block)) {
    if (kind == BlockKind::other_curve)
      deck.other_curves.emplace(*id, "*" + to_utf8(keyword_of(block)));
    else
      (kind == BlockKind::curve ? deck.curves : deck.tables).add(*id, std::move(block), text, faults);
  }
}

}  // namespace

LsDynaBlocks ls_dyna_blocks(const DeckText& text, MeasurementFaults& faults) {
  LsDynaBlocks deck;
  deck.parameters = std::make_unique<LsDynaScopes>(text);
  read_ls_dyna_parameters(text, *deck.parameters, faults);
  LineReader lines(text.text);
  std::string_view line;
  std::size_t place = 0;
  bool all_long = false, more = lines.next(line);
  while (more) {
    if (!line.starts_with('*')) {
      more = lines.next(line);
      continue;
    }
    DeckBlock block = begun_block({lines.number(), line}, all_long);
    block.place = place++;
    const std::string keyword = keyword_of(block);
    if (keyword == "END") break;
    if (keyword == "KEYWORD" && says_long(line)) all_long = true;
    const BlockKind kind = kind_of_block(keyword);
    bool is_encrypted = false;
    while ((more = lines.next(line)) && !line.starts_with('*')) {
      if (line.starts_with(begin_of_encrypted)) {
        is_encrypted = true;
        if (deck.out_of_reach.encrypted.empty()) deck.out_of_reach.encrypted = text.words_for(lines.number());
      }
      if (kind != BlockKind::unread && !line.starts_with('$') && !is_encrypted)
        block.lines.push_back(
            {lines.number(), line, &deck.parameters->of(text.place_of(lines.number()).file)});
      if (line.starts_with(end_of_encrypted)) is_encrypted = false;
    }
    while (!block.lines.empty() && without_blanks(block.lines.back().text).empty() && kind != BlockKind::foam)
      block.lines.pop_back();
    if (kind == BlockKind::unread)
      note_unread(keyword, deck.out_of_reach);
    else
      keep_ls_dyna_block(std::move(block), kind, text, deck, faults);
  }
  return deck;
}

std::optional<DeckCurve> ls_dyna_curve(const LsDynaSource& from, long id, const std::string& key,
                                       std::size_t asked) {
  const auto& [deck, units, faults] = from;
  const DeckBlock* const block = deck.curves.find(id);
  if (block == nullptr) {
    const auto other = deck.other_curves.find(id);
    faults.add(asked, key, fmt::format("{}", id),
               other != deck.other_curves.end()
                   ? fmt::format("curve {} is a {}; only *DEFINE_CURVE is read", id, other->second)
                   : missing(fmt::format("*DEFINE_CURVE {}", id), deck.out_of_reach));
    return std::nullopt;
  }
  const std::vector<DeckLine> lines = lines_behind_title(*block);
  if (lines.size() > max_lines_of_curve) {
    faults.add(block->head.number, fmt::format("curve {}", id), "", too_many_points(lines.size() - 1));
    return std::nullopt;
  }
  DeckFields head(lines.front(), equal_widths(8, block->long_format), true, faults);
  constexpr const char* keys_of_strain[]{"SFA", "OFFA"};
  constexpr const char* keys_of_stress[]{"SFO", "OFFO"};
  const Shift of_strain = read_shift(head, 2, 4, keys_of_strain);
  const Shift of_stress = read_shift(head, 3, 5, keys_of_stress, units.stress);
  DeckCurve curve{fmt::format("curve {}", id), block->head.number};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    DeckFields point(lines[i], pair_of_twenty, true, faults);
    const double strain = point.number(0, curve.name + ": A" + std::to_string(i));
    const double stress = point.number(1, curve.name + ": O" + std::to_string(i), units.stress);
    curve.add(of_strain.of(strain), of_stress.of(stress), lines[i].number);
    if (std::isinf(curve.strain.back()) || std::isinf(curve.stress.back())) {
      faults.add(lines[i].number, curve.name, "", "has a number that is too large once scaled");
      return std::nullopt;
    }
  }
  return curve;
}

std::optional<std::vector<DeckRateCurve>> ls_dyna_table(const LsDynaSource& from, long id,
                                                        const std::string& key, std::size_t asked) {
  const auto& [deck, units, faults] = from;
  const DeckBlock* const block = deck.tables.find(id);
  if (block == nullptr) {
    faults.add(asked, key, fmt::format("{}", id),
               deck.curves.find(id) != nullptr
                   ? "is a curve; a table of curves at several rates is needed"
                   : missing(fmt::format("*DEFINE_TABLE {}", id), deck.out_of_reach));
    return std::nullopt;
  }
  const std::vector<DeckLine> lines = lines_behind_title(*block);
  const std::string name = fmt::format("table {}", id);
  DeckFields head(lines.front(), equal_widths(3, block->long_format), true, faults);
  constexpr const char* keys_of_rate[]{"SFA", "OFFA"};
  const Shift of_rate = read_shift(head, 1, 2, keys_of_rate, units.rate);
  if (lines.size() < 2 || lines.size() > max_rates + 1) {
    faults.add(block->head.number, name, "",
               fmt::format("has {} rates; must have 1 to {}", lines.size() - 1, max_rates));
    return std::nullopt;
  }
  std::vector<DeckRateCurve> rows;
  bool sound = true;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    DeckFields row(lines[i], pair_of_twenty, true, faults);
    DeckRateCurve at{of_rate.of(row.number(0, name + ": rate", units.rate)), lines[i].number, {}};
    std::optional<DeckCurve> curve;
    if (!row.text(1).empty()) {
      if (const auto named = row.whole(1, name + ": LCID"))
        curve = ls_dyna_curve(from, *named, name + ": LCID", lines[i].number);
    } else if (keyword_of(*block) == "DEFINE_TABLE_2D") {
      faults.add(lines[i].number, name, "", "needs the number of a curve after the rate (columns 21 to 40)");
    } else {
      // The classic kind of table is directly followed by its *DEFINE_CURVE, in the order of the rates.
      long following = 0;
      if (const DeckBlock* const next = deck.curves.at_place(block->place + i)) {
        const std::vector<DeckLine> lines_of_next = lines_behind_title(*next);
        DeckFields first(lines_of_next.front(), equal_widths(1, next->long_format), true, faults);
        following = first.whole(0, "LCID").value_or(0);
        curve = ls_dyna_curve(from, following, name, lines[i].number);
      } else {
        faults.add(
            lines[i].number, name, "",
            fmt::format(
                "must be directly followed by one *DEFINE_CURVE per rate, {} in all; number {} is missing",
                lines.size() - 1, i));
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
