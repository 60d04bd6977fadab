// Conversion of the fields of LS-DYNA's cards.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/ls_dyna.hpp"

namespace dashpad::input {

namespace {

struct FieldOfCard {
  DeckFields& line;
  std::size_t place;
  std::string_view name;
  std::string key;  ///< for messages: "*MAT_083: HU"

  [[nodiscard]] double number(const DeckUnit& unit = {}) const { return line.number(place, key, unit); }
  [[nodiscard]] std::optional<long> whole() const { return line.whole(place, key); }
};

/// The lines of a material's block, one per card; absent, with a fault, if there are too few or too many.
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
    faults.add(lines[most].number, name, "", fmt::format("has too many lines; the limit is {}", most));
  return std::nullopt;
}

void take_curve(const FieldOfCard& field, const LsDynaSource& from, DeckFoam& foam) {
  const auto id = field.whole();
  if (!id) return;
  auto curve = ls_dyna_curve(from, *id, field.key, field.line.line());
  if (curve) foam.loading.push_back({0, curve->line, *std::move(curve)});
}

void take_table(const FieldOfCard& field, const LsDynaSource& from, DeckFoam& foam) {
  const auto id = field.whole();
  if (!id) return;
  if (*id == 0) {
    from.faults.add(field.line.line(), field.key, "",
                    "must refer to a table of curves; the constants on the cards below are not read");
    return;
  }
  if (*id < 0)
    foam.differences.push_back(
        fmt::format("{} is negative; the option that this selects is ignored.", field.name));
  auto rows = ls_dyna_table(from, std::labs(*id), field.key, field.line.line());
  if (rows) foam.loading = *std::move(rows);
}

/// Takes a field. False if the foam cannot be read with it.
bool take(const FieldOfCard& field, const LsDynaSource& from, DeckFoam& foam) {
  const std::string_view name = field.name;
  if (name == "MID") foam.id = field.whole().value_or(0);
  if (name == "RO") foam.density = field.number(from.units.density);
  if (name == "E") foam.modulus = field.number(from.units.stress);
  if (name == "LCID") take_curve(field, from, foam);
  if (name == "TBID" || name == "TID") take_table(field, from, foam);
  if (name == "HU")
    foam.unloading_factor =
        or_one(field.number(), "HU", foam,
               foam.card == "*MAT_083"
                   ? ", so unloading follows the curve for the lowest rate, without loss at that rate"
                   : ", which the solver treats as 1 (no energy loss)");
  if (name == "SHAPE") foam.unloading_shape = or_one(field.number(), "SHAPE", foam);
  if (name == "EXPON") tell_of_exponent(field.number(), "EXPON", foam);
  if (name == "SFLAG" && field.number() == 0 && foam.loading.size() > 1)
    foam.differences.emplace_back(
        "SFLAG = 0: the table gives rates of true strain, which Dashpad treats as rates of nominal strain.");
  return true;
}

/// Whether the card says MODEL = 0, before its further cards are counted.
bool is_model_zero(const DeckBlock& block, const LsDynaFoam& kind, const LsDynaSource& from,
                   const std::string& card) {
  const DeckCard first = kind.cards.front();
  const auto place = static_cast<std::size_t>(
      std::ranges::find(first, std::string_view("MODEL"), &DeckField::name) - first.begin());
  const std::vector<DeckLine> lines = lines_behind_title(block);
  if (place == first.size() || lines.empty()) return true;
  DeckFields fields(lines.front(), equal_widths(8, block.long_format), true, from.faults);
  const auto model = fields.whole(place, card + ": MODEL");
  if (!model || *model == 0) return true;
  from.faults.add(
      fields.line(), card + ": MODEL", fmt::format("{}", *model),
      "must be 0 (a curve against volumetric strain); curves against plastic strain are not read");
  return false;
}

bool read_cards(const DeckBlock& block, const LsDynaFoam& kind, const LsDynaSource& from, DeckFoam& foam) {
  if (!is_model_zero(block, kind, from, foam.card)) return false;
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

/// *MAT_063 has a single curve, along whose last slope newer versions of the solver unload.
void tell_of_last_slope(DeckFoam& foam) {
  if (foam.loading.empty()) return;
  const DeckCurve& curve = foam.loading.front().curve;
  const std::size_t n = curve.strain.size();
  if (n < 2) return;
  const double slope =
      (curve.stress[n - 1] - curve.stress[n - 2]) / (curve.strain[n - 1] - curve.strain[n - 2]);
  if (std::isfinite(slope))
    foam.differences.push_back(fmt::format(
        "Here the foam unloads with E; newer versions of the solver use the curve's last slope, {:.6g} Pa.",
        slope));
}

/// The rule that the options in a keyword break; "" if none.
std::string rule_for_option(const std::string& keyword, const LsDynaFoam& kind) {
  const std::string_view name =
      keyword.starts_with(fmt::format("MAT_{}", kind.words)) ? kind.words : kind.number;
  const std::string option = keyword.substr(4 + name.size());
  if (option.empty()) return "";
  if (kind.number == "083") {
    for (const char* const other : {"DAMAGE_DECAY", "PATH_DEPENDENT"})
      if (option.find(other) != std::string::npos)
        return fmt::format("is not read with the option {}, which has no counterpart in Dashpad", other);
    if (option == "_LOG_LOG_INTERPOLATION") return "";
  }
  return "has an unknown option";
}

/// What each *CONTROL_UNITS states: length, time and mass. With a second line, of scales, it is not
/// understood.
std::vector<StatedUnits> units_of_deck(const LsDynaBlocks& deck, MeasurementFaults& faults) {
  std::vector<StatedUnits> statements;
  for (const DeckBlock& block : deck.units) {
    if (block.lines.size() != 1) continue;
    const DeckLine& line = block.lines.front();
    const DeckFields fields(line, equal_widths(3, block.long_format), true, faults);
    statements.push_back(units_by_words(line.number, {fields.text(2), fields.text(0), fields.text(1)}));
  }
  return statements;
}

}  // namespace

std::vector<DeckFoam> read_ls_dyna(const DeckText& text, UnitChoice& units, MeasurementFaults& faults) {
  const LsDynaBlocks deck = ls_dyna_blocks(text, faults);
  if (deck.foams.empty()) {
    faults.add(0, "", "",
               contains_no("*MAT_057 (LOW_DENSITY_FOAM), *MAT_063 (CRUSHABLE_FOAM), *MAT_083 "
                           "(FU_CHANG_FOAM) or *MAT_163 (MODIFIED_CRUSHABLE_FOAM)",
                           deck.out_of_reach));
    return {};
  }
  const auto stated = units.agreed(units_of_deck(deck, faults));
  const auto chosen = stated ? units.for_numbers(*stated) : std::nullopt;
  if (!chosen) return {};
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : deck.foams) {
    const std::string keyword = keyword_of(block);
    const LsDynaFoam& kind = *ls_dyna_foam(keyword);
    DeckFoam foam;
    foam.card = fmt::format("*MAT_{}", kind.number);
    foam.line = block.head.number;
    foam.title = title_of(block);
    foam.units = chosen->words;
    foam.crushable = kind.crushable;
    foam.linear_in_rate = keyword.find("LOG_LOG") == std::string::npos;
    const std::string rule = rule_for_option(keyword, kind);
    if (!rule.empty())
      faults.add(block.head.number, foam.card, rule.starts_with("has") ? to_utf8(keyword) : "", rule);
    else if (read_cards(block, kind, {deck, chosen->units, faults}, foam)) {
      if (kind.number == "063") tell_of_last_slope(foam);
      foams.push_back(std::move(foam));
    }
  }
  return foams;
}

}  // namespace dashpad::input
