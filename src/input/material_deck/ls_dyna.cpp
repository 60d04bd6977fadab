// The foams of LS-DYNA: what stands in which field, and what becomes of it.

#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_blocks.hpp"

namespace dashpad::input {

namespace {

/// A tension cut-off of that size is none.
constexpr double no_cut_off = 1e19;

/// The lines of a material's block, a card each.
class MaterialCards {
 public:
  MaterialCards(const DeckBlock& block, std::string name, std::size_t fewest, std::size_t most,
                MeasurementFaults& faults)
      : name_(std::move(name)),
        lines_(lines_behind_title(block)),
        head_(block.head.number),
        long_format_(block.long_format),
        faults_(faults) {
    while (lines_.size() > most && without_blanks(lines_.back().text).empty()) lines_.pop_back();
    sound_ = lines_.size() >= fewest && lines_.size() <= most;
    if (lines_.size() < fewest)
      faults.add(head_, name_, "", fmt::format("ends after {} of {} lines", lines_.size(), fewest));
    else if (!sound_)
      faults.add(lines_[most].number, name_, "", fmt::format("has more than {} lines", most));
  }

  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] bool has(std::size_t card) const { return card < lines_.size(); }
  [[nodiscard]] DeckFields card(std::size_t card) const {
    return {lines_[card], equal_widths(8, long_format_), true, faults_};
  }
  [[nodiscard]] std::string key(const char* field) const { return name_ + ": " + field; }

 private:
  std::string name_;
  std::vector<DeckLine> lines_;
  std::size_t head_;
  bool long_format_, sound_ = false;
  MeasurementFaults& faults_;
};

/// Tells of a field that has no counterpart here, where it is set.
void tell_if_set(DeckFields& card, std::size_t field, const MaterialCards& of, const char* name,
                 const char* meaning, DeckFoam& foam) {
  const double value = card.number(field, of.key(name));
  if (value == value && value != 0 && std::abs(value) < no_cut_off)
    foam.differences.push_back(fmt::format("{} = {:g}: {}.", name, value, meaning));
}

void tell_of_true_rates(DeckFields& second, const MaterialCards& of, DeckFoam& foam) {
  if (second.number(1, of.key("SFLAG")) == 0 && foam.loading.size() > 1)
    foam.differences.emplace_back(
        "SFLAG = 0: the rates of the table are those of the true strain; here they are taken for rates "
        "of the nominal strain.");
}

/// What 057 and 083 leave to a default.
double factor_or_default(double given, const char* solver_takes, double fallback, DeckFoam& foam) {
  if (given != 0) return given;
  foam.assumptions.emplace_back(solver_takes);
  return fallback;
}

/// Number, density and modulus, which every card begins with.
void read_beginning(DeckFields& card, const MaterialCards& of, const DeckUnits& units, DeckFoam& foam) {
  foam.id = card.whole(0, of.key("MID")).value_or(0);
  foam.density = card.number(1, of.key("RO"), units.density);
  foam.modulus = card.number(2, of.key("E"), units.stress);
}

struct Source {
  const LsDynaBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};

void take_curve(DeckFields& card, std::size_t field, const MaterialCards& of, const Source& from,
                DeckFoam& foam) {
  const auto id = card.whole(field, of.key("LCID"));
  if (!id) return;
  auto curve = ls_dyna_curve(from.deck, *id, of.key("LCID"), card.line(), from.units, from.faults);
  if (curve) foam.loading.push_back({0, curve->line, *std::move(curve)});
}

void take_table(DeckFields& card, std::size_t field, const MaterialCards& of, const char* name,
                const Source& from, DeckFoam& foam) {
  const auto id = card.whole(field, of.key(name));
  if (!id) return;
  if (*id == 0) {
    from.faults.add(card.line(), of.key(name), "",
                    "must name a table of curves; the constants of the cards below are not read");
    return;
  }
  if (*id < 0)
    foam.differences.push_back(fmt::format("{} is negative: the option that this switches on.", name));
  auto rows = ls_dyna_table(from.deck, std::labs(*id), of.key(name), card.line(), from.units, from.faults);
  if (rows) foam.loading = *std::move(rows);
}

bool read_low_density_foam(const DeckBlock& block, const Source& from, DeckFoam& foam) {
  const MaterialCards cards(block, foam.card, 2, 2, from.faults);
  if (!cards.sound()) return false;
  DeckFields first = cards.card(0), second = cards.card(1);
  read_beginning(first, cards, from.units, foam);
  take_curve(first, 3, cards, from, foam);
  tell_if_set(first, 4, cards, "TC", "a pad carries no tension", foam);
  foam.unloading_factor = factor_or_default(
      first.number(5, cards.key("HU")), "HU is blank or 0, which the solver takes for 1: no loss.", 1, foam);
  tell_if_set(first, 6, cards, "BETA", "the loss of the unloading does not fade with time here", foam);
  tell_if_set(first, 7, cards, "DAMP", "the viscous damping of the element is left out", foam);
  foam.unloading_shape = factor_or_default(second.number(0, cards.key("SHAPE")),
                                           "SHAPE is blank or 0, which the solver takes for 1.", 1, foam);
  tell_if_set(second, 1, cards, "FAIL", "a pad carries no tension", foam);
  tell_if_set(second, 2, cards, "BVFLAG", "there is no bulk viscosity", foam);
  tell_if_set(second, 3, cards, "ED", "the viscoelastic part is left out", foam);
  tell_if_set(second, 4, cards, "BETA1", "the viscoelastic part is left out", foam);
  tell_if_set(second, 5, cards, "KCON", "the contact does not need a stiffness", foam);
  tell_if_set(second, 6, cards, "REF", "there is no reference geometry", foam);
  return true;
}

bool read_fu_chang_foam(const DeckBlock& block, const Source& from, DeckFoam& foam) {
  const std::string keyword = keyword_of(block);
  for (const char* const option : {"DAMAGE_DECAY", "PATH_DEPENDENT"})
    if (keyword.find(option) != std::string::npos) {
      from.faults.add(block.head.number, foam.card, "",
                      fmt::format("is not read with the option {}, which has no counterpart here", option));
      return false;
    }
  foam.linear_in_rate = keyword.find("LOG_LOG") == std::string::npos;
  const MaterialCards cards(block, foam.card, 4, 5, from.faults);
  if (!cards.sound()) return false;
  DeckFields first = cards.card(0), second = cards.card(1), fourth = cards.card(3);
  read_beginning(first, cards, from.units, foam);
  tell_if_set(first, 3, cards, "KCON", "the contact does not need a stiffness", foam);
  tell_if_set(first, 4, cards, "TC", "a pad carries no tension", foam);
  tell_if_set(first, 5, cards, "FAIL", "a pad carries no tension", foam);
  tell_if_set(first, 6, cards, "DAMP", "the viscous damping of the element is left out", foam);
  take_table(first, 7, cards, "TBID", from, foam);
  tell_if_set(second, 0, cards, "BVFLAG", "there is no bulk viscosity", foam);
  tell_of_true_rates(second, cards, foam);
  tell_if_set(second, 2, cards, "RFLAG", "the rate is that of the compression", foam);
  tell_if_set(second, 3, cards, "TFLAG", "a pad carries no tension", foam);
  tell_if_set(second, 4, cards, "PVID", "the curve of the pressure is left out", foam);
  tell_if_set(second, 5, cards, "SRAF", "the rate is not averaged over time steps; see lag_strain", foam);
  tell_if_set(second, 6, cards, "REF", "there is no reference geometry", foam);
  foam.unloading_factor = factor_or_default(
      second.number(7, cards.key("HU")),
      "HU is blank or 0: the unloading follows the slowest curve, without loss on it.", 1, foam);
  foam.unloading_shape = factor_or_default(fourth.number(7, cards.key("SHAPE")),
                                           "SHAPE is blank or 0, which the solver takes for 1.", 1, foam);
  if (!cards.has(4)) return true;
  DeckFields fifth = cards.card(4);
  if (const double alpha = fifth.number(0, cards.key("EXPON")); alpha == alpha && alpha != 0 && alpha != 1)
    foam.differences.push_back(fmt::format(
        "EXPON = {:g}: the unloading here has the exponent 1, so the foam loses another part of its work.",
        alpha));
  tell_if_set(fifth, 1, cards, "RIULD", "the unloading is as recoil says", foam);
  return true;
}

bool read_crushable_foam(const DeckBlock& block, const Source& from, DeckFoam& foam) {
  const MaterialCards cards(block, foam.card, 1, 1, from.faults);
  if (!cards.sound()) return false;
  DeckFields card = cards.card(0);
  read_beginning(card, cards, from.units, foam);
  tell_if_set(card, 3, cards, "PR", "the pad does not widen", foam);
  if (const auto model = card.whole(7, cards.key("MODEL")); model && *model != 0) {
    from.faults.add(card.line(), cards.key("MODEL"), fmt::format("{}", *model),
                    "must be 0: a curve over the volumetric strain is read, none over a plastic strain");
    return false;
  }
  take_curve(card, 4, cards, from, foam);
  tell_if_set(card, 5, cards, "TSC", "a pad carries no tension", foam);
  tell_if_set(card, 6, cards, "DAMP", "the viscous damping of the element is left out", foam);
  if (foam.loading.empty()) return true;
  const DeckCurve& curve = foam.loading.front().curve;
  if (const std::size_t n = curve.strain.size(); n > 1) {
    const double slope =
        (curve.stress[n - 1] - curve.stress[n - 2]) / (curve.strain[n - 1] - curve.strain[n - 2]);
    if (std::isfinite(slope))
      foam.differences.push_back(
          fmt::format("The foam unloads with E; newer versions of the solver take the last slope of the "
                      "curve, {:.6g} Pa, "
                      "in its place.",
                      slope));
  }
  return true;
}

bool read_modified_crushable_foam(const DeckBlock& block, const Source& from, DeckFoam& foam) {
  const MaterialCards cards(block, foam.card, 2, 2, from.faults);
  if (!cards.sound()) return false;
  DeckFields first = cards.card(0), second = cards.card(1);
  read_beginning(first, cards, from.units, foam);
  tell_if_set(first, 3, cards, "PR", "the pad does not widen", foam);
  take_table(first, 4, cards, "TID", from, foam);
  tell_if_set(first, 5, cards, "TSC", "a pad carries no tension", foam);
  tell_if_set(first, 6, cards, "DAMP", "the viscous damping of the element is left out", foam);
  tell_if_set(first, 7, cards, "NCYCLE", "the rate is not averaged over time steps; see lag_strain", foam);
  tell_if_set(second, 0, cards, "SRCLMT", "the change of the rate has no limit; see lag_strain", foam);
  tell_of_true_rates(second, cards, foam);
  return true;
}

/// A keyword in words and as a number, and how its cards are read.
struct FoamKeyword {
  const char* words;
  const char* number;
  bool crushable;
  bool (*read)(const DeckBlock&, const Source&, DeckFoam&);
};
constexpr FoamKeyword foam_keywords[]{
    {"MODIFIED_CRUSHABLE_FOAM", "163", true, read_modified_crushable_foam},
    {"CRUSHABLE_FOAM", "063", true, read_crushable_foam},
    {"FU_CHANG_FOAM", "083", false, read_fu_chang_foam},
    {"LOW_DENSITY_FOAM", "057", false, read_low_density_foam},
};

const FoamKeyword& keyword_for(const std::string& keyword) {
  for (const FoamKeyword& each : foam_keywords)
    if (keyword.starts_with(std::string("MAT_") + each.words) ||
        keyword.starts_with(std::string("MAT_") + each.number))
      return each;
  return foam_keywords[0];  // ls_dyna_blocks() has no others
}

/// What a keyword has behind its name that is not known.
bool has_unknown_option(const std::string& keyword, const FoamKeyword& of) {
  const std::string name = keyword.starts_with(std::string("MAT_") + of.words) ? of.words : of.number;
  const std::string rest = keyword.substr(4 + name.size());
  return !rest.empty() &&
         !(of.read == read_fu_chang_foam &&
           (rest == "_LOG_LOG_INTERPOLATION" || rest.find("DAMAGE_DECAY") != std::string::npos ||
            rest.find("PATH_DEPENDENT") != std::string::npos));
}

std::string no_foam(const LsDynaBlocks& deck) {
  std::string text =
      "holds no *MAT_057 (LOW_DENSITY_FOAM), *MAT_063 (CRUSHABLE_FOAM), *MAT_083 (FU_CHANG_FOAM) or *MAT_163 "
      "(MODIFIED_CRUSHABLE_FOAM)";
  for (std::size_t i = 0; i < deck.other_materials.size(); ++i)
    text += (i == 0 ? "; there are " : ", ") + deck.other_materials[i];
  return text;
}

}  // namespace

std::vector<DeckFoam> read_ls_dyna(std::string_view text, const DeckUnits& units, MeasurementFaults& faults) {
  const LsDynaBlocks deck = ls_dyna_blocks(text, faults);
  if (deck.foams.empty()) faults.add(0, "", "", no_foam(deck));
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : deck.foams) {
    const std::string keyword = keyword_of(block);
    const FoamKeyword& kind = keyword_for(keyword);
    DeckFoam foam;
    foam.card = std::string("*MAT_") + kind.number;
    foam.line = block.head.number;
    foam.title = title_of(block);
    foam.crushable = kind.crushable;
    if (has_unknown_option(keyword, kind))
      faults.add(block.head.number, foam.card, to_utf8(keyword), "has an option that is not known");
    else if (kind.read(block, {deck, units, faults}, foam))
      foams.push_back(std::move(foam));
  }
  return foams;
}

}  // namespace dashpad::input
