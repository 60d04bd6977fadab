// *KEYWORD input of LS-DYNA: "*" in the first column begins a keyword, "$" a comment. Its blocks, the curves
// and tables among them, and what becomes of the fields of the cards of its foams.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

namespace {

/// The blocks of *KEYWORD input that are foams, curves or tables.
struct LsDynaBlocks {
  std::vector<DeckBlock> foams;
  NumberedBlocks curves{"curve"};
  NumberedBlocks tables{"table"};
  std::vector<std::string> other_materials;  ///< keywords of materials that are not read
  bool includes_files = false;
};

/// The lines of a block behind its title, if it has one.
std::vector<DeckLine> lines_behind_title(const DeckBlock& block) {
  const bool has_title = block.keyword.find("_TITLE") != std::string::npos && !block.lines.empty();
  return {block.lines.begin() + (has_title ? 1 : 0), block.lines.end()};
}

/// The title, UTF-8; empty where the keyword has none.
std::string title_of(const DeckBlock& block) {
  if (block.keyword.find("_TITLE") == std::string::npos || block.lines.empty()) return "";
  return to_utf8(without_blanks(block.lines.front().text.substr(0, 80)));
}

/// The keyword without _TITLE.
std::string keyword_of(const DeckBlock& block) {
  std::string keyword = block.keyword;
  if (const auto at = keyword.find("_TITLE"); at != std::string::npos) keyword.erase(at, 6);
  return keyword;
}

/// Of a keyword without its title, such as MAT_083; null where it is none of a foam that is read.
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

constexpr std::size_t max_materials_listed = 10;

/// "*MAT_057_TITLE +": the keyword, and whether its fields are long.
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

bool says_long(const std::string& head) {
  const std::string text = upper_case(head);
  const auto at = text.find("LONG=");
  return at != std::string::npos && text.substr(at + 5, 1) != "S";
}

/// The number in the first field; absent where there is none. Curves that no foam asks for may be anything.
std::optional<long> number_of_block(const DeckBlock& block) {
  const std::vector<DeckLine> lines = lines_behind_title(block);
  if (lines.empty()) return std::nullopt;
  const std::string_view line = lines.front().text;
  const auto comma = line.find(',');
  const std::size_t width = comma != std::string_view::npos ? comma : block.long_format ? 20 : 10;
  const ReadNumber read = read_deck_number(line.substr(0, width), {});
  if (read.kind != NumberKind::number || !(std::abs(read.value) < 1e10)) return std::nullopt;
  return static_cast<long>(read.value);
}

const Widths pair_of_twenty{20, 20};

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

LsDynaBlocks ls_dyna_blocks(std::string_view text, MeasurementFaults& faults) {
  LsDynaBlocks deck;
  LineReader lines(text);
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
    if (keyword == "KEYWORD" && says_long(std::string(line))) all_long = true;
    const bool foam = ls_dyna_foam(keyword) != nullptr;
    const bool curve = keyword == "DEFINE_CURVE";
    const bool table = keyword == "DEFINE_TABLE" || keyword == "DEFINE_TABLE_2D";
    while ((more = lines.next(line)) && !line.starts_with('*'))
      if ((foam || curve || table) && !line.starts_with('$')) block.lines.push_back({lines.number(), line});
    while (!block.lines.empty() && without_blanks(block.lines.back().text).empty() && !foam)
      block.lines.pop_back();
    if (foam) {
      if (deck.foams.size() == max_foams_of_deck)
        faults.refuse(block.head.number, "", "", fmt::format("more than {} foams", max_foams_of_deck));
      deck.foams.push_back(std::move(block));
    } else if (keyword.starts_with("MAT_") && deck.other_materials.size() < max_materials_listed)
      deck.other_materials.push_back("*" + to_utf8(keyword));
    else if (keyword.starts_with("INCLUDE"))
      deck.includes_files = true;
    if (!curve && !table) continue;
    if (const auto id = number_of_block(block))
      (curve ? deck.curves : deck.tables).add(*id, std::move(block), faults);
  }
  return deck;
}

std::optional<DeckCurve> ls_dyna_curve(const LsDynaBlocks& deck, long id, const std::string& key,
                                       std::size_t asked, const DeckUnits& units, MeasurementFaults& faults) {
  const DeckBlock* const block = deck.curves.find(id);
  if (block == nullptr) {
    faults.add(asked, key, fmt::format("{}", id), missing(deck, "*DEFINE_CURVE", id));
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
  if (lines.size() < 2 || lines.size() > max_rates + 1) {
    faults.add(block->head.number, name, "",
               fmt::format("has {} rates; must have between 1 and {}", lines.size() - 1, max_rates));
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

struct Source {
  const LsDynaBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};

/// A field of a card that is read.
struct FieldOfCard {
  DeckFields& line;
  std::size_t place;
  std::string_view name;
  std::string key;  ///< for messages: "*MAT_083: HU"

  [[nodiscard]] double number(const DeckUnit& unit = {}) const { return line.number(place, key, unit); }
  [[nodiscard]] std::optional<long> whole() const { return line.whole(place, key); }
};

/// Lines of a material's block, a card each; nothing, and a fault, where there are too few or too many.
std::optional<std::vector<DeckLine>> cards_of(const DeckBlock& block, const LsDynaFoam& kind,
                                              const std::string& name, MeasurementFaults& faults) {
  std::vector<DeckLine> lines = lines_behind_title(block);
  const std::size_t most = kind.cards.size();
  while (lines.size() > most && without_blanks(lines.back().text).empty()) lines.pop_back();
  if (lines.size() >= kind.fewest && lines.size() <= most) return lines;
  if (lines.size() < kind.fewest)
    faults.add(block.head.number, name, "",
               fmt::format("ends after {} of {} lines", lines.size(), kind.fewest));
  else
    faults.add(lines[most].number, name, "", fmt::format("has more than {} lines", most));
  return std::nullopt;
}

void take_curve(const FieldOfCard& field, const Source& from, DeckFoam& foam) {
  const auto id = field.whole();
  if (!id) return;
  auto curve = ls_dyna_curve(from.deck, *id, field.key, field.line.line(), from.units, from.faults);
  if (curve) foam.loading.push_back({0, curve->line, *std::move(curve)});
}

void take_table(const FieldOfCard& field, const Source& from, DeckFoam& foam) {
  const auto id = field.whole();
  if (!id) return;
  if (*id == 0) {
    from.faults.add(field.line.line(), field.key, "",
                    "must name a table of curves; the constants of the cards below are not read");
    return;
  }
  if (*id < 0)
    foam.differences.push_back(fmt::format("{} is negative: the option that this switches on.", field.name));
  auto rows = ls_dyna_table(from.deck, std::labs(*id), field.key, field.line.line(), from.units, from.faults);
  if (rows) foam.loading = *std::move(rows);
}

/// False where it makes the foam one that is not read.
bool take(const FieldOfCard& field, const Source& from, DeckFoam& foam) {
  const std::string_view name = field.name;
  if (name == "MID") foam.id = field.whole().value_or(0);
  if (name == "RO") foam.density = field.number(from.units.density);
  if (name == "E") foam.modulus = field.number(from.units.stress);
  if (name == "LCID") take_curve(field, from, foam);
  if (name == "TBID" || name == "TID") take_table(field, from, foam);
  if (name == "HU")
    foam.unloading_factor =
        or_one(field.number(),
               foam.card == "*MAT_083"
                   ? "HU is blank or 0: the unloading follows the slowest curve, without loss on it."
                   : "HU is blank or 0, which the solver takes for 1: no loss.",
               foam);
  if (name == "SHAPE")
    foam.unloading_shape = or_one(field.number(), "SHAPE is blank or 0, which the solver takes for 1.", foam);
  if (name == "EXPON") tell_of_exponent(field.number(), "EXPON", foam);
  if (name == "SFLAG" && field.number() == 0 && foam.loading.size() > 1)
    foam.differences.emplace_back(
        "SFLAG = 0: the rates of the table are those of the true strain; here they are taken for rates "
        "of the nominal strain.");
  if (name != "MODEL") return true;
  const auto model = field.whole();
  if (!model || *model == 0) return true;
  from.faults.add(field.line.line(), field.key, fmt::format("{}", *model),
                  "must be 0: a curve over the volumetric strain is read, none over a plastic strain");
  return false;
}

bool read_cards(const DeckBlock& block, const LsDynaFoam& kind, const Source& from, DeckFoam& foam) {
  const auto lines = cards_of(block, kind, foam.card, from.faults);
  if (!lines) return false;
  for (std::size_t i = 0; i < lines->size(); ++i) {
    const DeckCard card = kind.cards[i];
    if (std::ranges::none_of(card, &DeckField::matters)) continue;
    DeckFields line((*lines)[i], equal_widths(8, block.long_format), true, from.faults);
    for (std::size_t place = 0; place < card.size(); ++place) {
      const DeckField& field = card[place];
      const std::string key = foam.card + ": " + field.name;
      if (field.is_read() && !take({line, place, field.name, key}, from, foam)) return false;
      if (!field.is_read() && field.matters()) tell_if_set(line.number(place, key), field, foam);
    }
  }
  return true;
}

/// *MAT_063 has one curve, after which newer versions of the solver unload.
void tell_of_last_slope(DeckFoam& foam) {
  if (foam.loading.empty()) return;
  const DeckCurve& curve = foam.loading.front().curve;
  const std::size_t n = curve.strain.size();
  if (n < 2) return;
  const double slope =
      (curve.stress[n - 1] - curve.stress[n - 2]) / (curve.strain[n - 1] - curve.strain[n - 2]);
  if (std::isfinite(slope))
    foam.differences.push_back(
        fmt::format("The foam unloads with E; newer versions of the solver take the last slope of the "
                    "curve, {:.6g} Pa, in its place.",
                    slope));
}

/// What an option behind the name forbids; "" where nothing does.
std::string rule_for_option(const std::string& keyword, const LsDynaFoam& kind) {
  const std::string_view name =
      keyword.starts_with(fmt::format("MAT_{}", kind.words)) ? kind.words : kind.number;
  const std::string option = keyword.substr(4 + name.size());
  if (option.empty()) return "";
  if (kind.number == "083") {
    for (const char* const other : {"DAMAGE_DECAY", "PATH_DEPENDENT"})
      if (option.find(other) != std::string::npos)
        return fmt::format("is not read with the option {}, which has no counterpart here", other);
    if (option == "_LOG_LOG_INTERPOLATION") return "";
  }
  return "has an option that is not known";
}

}  // namespace

std::vector<DeckFoam> read_ls_dyna(std::string_view text, const DeckUnits& units, MeasurementFaults& faults) {
  const LsDynaBlocks deck = ls_dyna_blocks(text, faults);
  if (deck.foams.empty())
    faults.add(0, "", "",
               "holds no *MAT_057 (LOW_DENSITY_FOAM), *MAT_063 (CRUSHABLE_FOAM), *MAT_083 (FU_CHANG_FOAM) or "
               "*MAT_163 (MODIFIED_CRUSHABLE_FOAM)" +
                   others_listed(deck.other_materials));
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : deck.foams) {
    const std::string keyword = keyword_of(block);
    const LsDynaFoam& kind = *ls_dyna_foam(keyword);
    DeckFoam foam;
    foam.card = fmt::format("*MAT_{}", kind.number);
    foam.line = block.head.number;
    foam.title = title_of(block);
    foam.crushable = kind.crushable;
    foam.linear_in_rate = keyword.find("LOG_LOG") == std::string::npos;
    const std::string rule = rule_for_option(keyword, kind);
    if (!rule.empty())
      faults.add(block.head.number, foam.card, rule.starts_with("has") ? to_utf8(keyword) : "", rule);
    else if (read_cards(block, kind, {deck, units, faults}, foam)) {
      if (kind.number == "063") tell_of_last_slope(foam);
      foams.push_back(std::move(foam));
    }
  }
  return foams;
}

}  // namespace dashpad::input
