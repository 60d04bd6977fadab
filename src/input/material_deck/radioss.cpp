// The foams of Radioss: what stands in which field, and what becomes of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/material_deck/deck_blocks.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

using Widths = std::vector<std::size_t>;

struct RadiossSource {
  const RadiossBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};

/// The lines of one material behind its title, taken one after the other.
class LawLines {
 public:
  LawLines(const DeckBlock& block, std::string name, MeasurementFaults& faults)
      : block_(block), name_(std::move(name)), faults_(faults) {}

  /// Absent at the end, which is a fault.
  std::optional<DeckFields> next(const Widths& widths) {
    if (taken_ + 1 < block_.lines.size()) return DeckFields(block_.lines[++taken_], widths, false, faults_);
    if (!told_)
      faults_.add(block_.head.number, name_, "",
                  fmt::format("ends after {} {}", taken_, taken_ == 1 ? "line" : "lines"));
    told_ = true;
    return std::nullopt;
  }
  [[nodiscard]] bool at_end() const { return taken_ + 1 >= block_.lines.size(); }
  [[nodiscard]] std::string key(const std::string& field) const { return name_ + ": " + field; }
  [[nodiscard]] std::string title() const {
    return block_.lines.empty() ? "" : to_utf8(without_blanks(block_.lines.front().text.substr(0, 100)));
  }

 private:
  const DeckBlock& block_;
  std::string name_;
  MeasurementFaults& faults_;
  std::size_t taken_ = 0;
  bool told_ = false;
};

void tell_if_filled(DeckFields& line, std::size_t field, const LawLines& of, const char* name,
                    const char* meaning, DeckFoam& foam) {
  const double value = line.number(field, of.key(name));
  if (value == value && value != 0 && std::abs(value) < 1e19)
    foam.differences.push_back(fmt::format("{} = {:g}: {}.", name, value, meaning));
}

double or_default(double given, const char* solver_takes, DeckFoam& foam) {
  if (given != 0) return given;
  foam.assumptions.emplace_back(solver_takes);
  return 1;
}

/// The points of a function, stresses times `scale`.
std::optional<DeckCurve> function_of(const RadiossSource& from, long id, double scale, const std::string& key,
                                     std::size_t asked) {
  const DeckBlock* const block = from.deck.functions.find(id);
  if (block == nullptr) {
    from.faults.add(
        asked, key, fmt::format("{}", id),
        fmt::format(
            "there is no /FUNCT/{}{}", id,
            from.deck.includes_files ? "; files of #include are not read: put it into this deck" : ""));
    return std::nullopt;
  }
  if (block->lines.size() > most_lines_of_curve) {
    from.faults.add(
        block->head.number, fmt::format("function {}", id), "",
        fmt::format("has {} points; {} are the most", block->lines.size() - 1, TableCurve::most_points));
    return std::nullopt;
  }
  DeckCurve curve{fmt::format("function {}", id), block->head.number, {}, {}, {}};
  for (std::size_t i = 1; i < block->lines.size(); ++i) {
    DeckFields point(block->lines[i], {20, 20}, false, from.faults);
    curve.strain.push_back(point.number(0, curve.name + ": X" + std::to_string(i)));
    const double stress = point.number(1, curve.name + ": Y" + std::to_string(i), from.units.stress);
    curve.stress.push_back(scale == 1 ? stress : scale * stress);
    curve.lines.push_back(point.line());
  }
  return curve;
}

/// A line with function, rate and scale.
std::optional<DeckRateCurve> row_of(LawLines& lines, const RadiossSource& from) {
  auto row = lines.next({10, 20, 20});
  if (!row) return std::nullopt;
  const auto id = row->whole(0, lines.key("fct_ID"));
  DeckRateCurve at{row->number(1, lines.key("Eps_dot"), from.units.rate), row->line(), {}};
  const double scale = row->number(2, lines.key("Fscale"));
  if (!id || scale != scale) return std::nullopt;
  auto curve = function_of(from, *id, scale == 0 ? 1 : scale, lines.key("fct_ID"), row->line());
  if (!curve) return std::nullopt;
  at.curve = *std::move(curve);
  return at;
}

/// So many rows; false where one is missing or at fault.
bool read_rows(long count, LawLines& lines, const RadiossSource& from, std::vector<DeckRateCurve>& rows) {
  bool sound = true;
  for (long i = 0; i < count; ++i) {
    auto row = row_of(lines, from);
    sound = sound && row;
    if (row) rows.push_back(*std::move(row));
  }
  return sound;
}

/// The number of rows; absent where it is none that can be.
std::optional<long> count_in(DeckFields& line, std::size_t field, const LawLines& of, const char* name,
                             long fewest, MeasurementFaults& faults, std::size_t most = most_rates) {
  const auto count = line.whole(field, of.key(name));
  if (!count || (*count >= fewest && *count <= static_cast<long>(most))) return count;
  faults.add(line.line(), of.key(name), fmt::format("{}", *count),
             fmt::format("must be between {} and {}", fewest, most));
  return std::nullopt;
}

bool read_density_line(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  auto line = lines.next({20, 20});
  if (line) foam.density = line->number(0, lines.key("RHO_I"), from.units.density);
  return line.has_value();
}

bool read_law_90(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  if (!read_density_line(lines, from, foam)) return false;
  auto elastic = lines.next({20, 20});
  auto flags = lines.next({10, 10, 20, 20, 20, 20});
  if (!elastic || !flags) return false;
  foam.modulus = elastic->number(0, lines.key("E0"), from.units.stress);
  tell_if_filled(*elastic, 1, lines, "nu", "the pad does not widen", foam);
  tell_if_filled(*flags, 1, lines, "Ismooth", "the rate is not filtered; see lag_strain", foam);
  foam.unloading_shape = or_default(flags->number(3, lines.key("Shape")),
                                    "Shape is blank or 0, which the solver takes for 1.", foam);
  foam.unloading_factor = or_default(flags->number(4, lines.key("Hys")),
                                     "Hys is blank or 0, which the solver takes for 1: no loss.", foam);
  if (const double alpha = flags->number(5, lines.key("Alpha")); alpha == alpha && alpha != 0 && alpha != 1)
    foam.differences.push_back(fmt::format(
        "Alpha = {:g}: the unloading here has the exponent 1, so the foam loses another part of its work.",
        alpha));
  const auto count = count_in(*flags, 0, lines, "NL", 1, from.faults);
  return count && read_rows(*count, lines, from, foam.loading);
}

/// What Iflag makes of the unloading.
void settle_unloading_70(long flag, double shape, double factor, std::vector<DeckRateCurve> ways_back,
                         DeckFoam& foam) {
  if (flag >= 3) {
    foam.unloading_shape = or_default(shape, "Shape is blank or 0, which the solver takes for 1.", foam);
    foam.unloading_factor =
        or_default(factor, "Hys is blank or 0, which the solver takes for 1: no loss.", foam);
    if (flag == 3)
      foam.differences.emplace_back("Iflag = 3 lessens shear stresses only; here the whole stress.");
  } else if (ways_back.empty()) {
    foam.assumptions.emplace_back(
        "There is no unloading function, so the foam unloads along its slowest curve.");
  } else {
    foam.unloading = std::move(ways_back.front().curve);
    if (ways_back.size() > 1)
      foam.differences.emplace_back("Of the unloading functions only the first, the slowest, was taken.");
    foam.differences.emplace_back(
        "The unloading function is that of the way back from the last strain; from smaller strains it is "
        "scaled "
        "with the work done, where the solver drops to one and the same curve.");
  }
}

bool read_law_70(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  if (!read_density_line(lines, from, foam)) return false;
  auto elastic = lines.next({20, 20, 20, 20, 10});
  auto flags = lines.next({20, 10, 10, 10, 10, 20, 20});
  if (!elastic || !flags) return false;
  foam.modulus = elastic->number(0, lines.key("E0"), from.units.stress);
  tell_if_filled(*elastic, 1, lines, "nu", "the pad does not widen", foam);
  tell_if_filled(*elastic, 2, lines, "E_max", "the stress follows its curves at once, by no modulus", foam);
  tell_if_filled(*elastic, 4, lines, "Itens", "a pad carries no tension", foam);
  tell_if_filled(*flags, 0, lines, "Fcut", "the rate is not filtered; see lag_strain", foam);
  const auto count = count_in(*flags, 2, lines, "NL", 1, from.faults);
  const auto count_back = count_in(*flags, 3, lines, "NuL", 0, from.faults);
  const auto flag = flags->whole(4, lines.key("Iflag"));
  const double shape = flags->number(5, lines.key("Shape")), factor = flags->number(6, lines.key("Hys"));
  if (!count || !count_back || !flag) return false;
  if (*flag < 0 || *flag > 4) {
    from.faults.add(flags->line(), lines.key("Iflag"), fmt::format("{}", *flag), "must be between 0 and 4");
    return false;
  }
  std::vector<DeckRateCurve> ways_back;
  if (!read_rows(*count, lines, from, foam.loading) || !read_rows(*count_back, lines, from, ways_back))
    return false;
  settle_unloading_70(*flag, shape, factor, std::move(ways_back), foam);
  return true;
}

/// |A + B (1 + C gamma)| at gamma = -strain, as points up to nearly no volume of air.
DeckCurve yield_formula(double a, double b, double c, double phi, std::size_t line) {
  constexpr int count = 40;
  DeckCurve curve{"the yield stress A + B (1 + C gamma)", line, {}, {}, {}};
  for (int i = 0; i <= count; ++i) {
    const double e = 0.95 * (1 - phi) * i / count;
    curve.strain.push_back(e);
    curve.stress.push_back(std::abs(a + b * (1 - c * e)));
    curve.lines.push_back(line);
  }
  return curve;
}

/// From gamma = V/V0 - 1, negative in compression, to a strain.
void mirror(DeckCurve& curve) {
  for (double& strain : curve.strain) strain = strain == 0 ? 0 : -strain;
  std::ranges::reverse(curve.strain);
  std::ranges::reverse(curve.stress);
  std::ranges::reverse(curve.lines);
}

bool read_law_33(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  if (!read_density_line(lines, from, foam)) return false;
  auto elastic = lines.next({20, 10, 10, 20});
  auto gas = lines.next({20, 20, 20});
  auto yield = lines.next({20, 20, 20, 20});
  if (!elastic || !gas || !yield) return false;
  foam.modulus = elastic->number(0, lines.key("E"), from.units.stress);
  tell_if_filled(*elastic, 1, lines, "Ka", "the viscous part of the skeleton is left out", foam);
  const auto function = elastic->whole(2, lines.key("fct_IDf"));
  const double scale = elastic->number(3, lines.key("Fscale"));
  foam.air = {gas->number(0, lines.key("P0"), from.units.stress), gas->number(1, lines.key("Phi"))};
  const double gamma_0 = gas->number(2, lines.key("Gamma_0"));
  const double a = yield->number(0, lines.key("A"), from.units.stress);
  const double b = yield->number(1, lines.key("B"), from.units.stress);
  const double c = yield->number(2, lines.key("C"));
  tell_if_filled(*yield, 3, lines, "SIG_COFF", "a pad carries no tension", foam);
  if (!function || scale != scale || !(a == a && b == b && c == c && gamma_0 == gamma_0)) return false;
  if (gamma_0 != 0) {
    from.faults.add(gas->line(), lines.key("Gamma_0"), fmt::format("{:g}", gamma_0),
                    "must be 0: foam that is compressed from the start is not read");
    return false;
  }
  if (!(foam.air.pressure >= 0 && foam.air.relative_density >= 0 && foam.air.relative_density < 1)) {
    from.faults.add(gas->line(), lines.key("P0"), "",
                    "the pressure must not be negative, and Phi be in [0, 1)");
    return false;
  }
  if (foam.air.pressure > 0)
    foam.differences.emplace_back(
        "The pressure of the air is part of the crush curve; it does not push the crushed foam back here.");
  if (*function == 0) {
    DeckCurve curve = yield_formula(a, b, c, foam.air.relative_density, yield->line());
    foam.assumptions.push_back(
        fmt::format("The yield stress |A + B (1 + C gamma)| is given as points up to a "
                    "strain of {:.3g}.",
                    curve.strain.back()));
    foam.loading.push_back({0, yield->line(), std::move(curve)});
    return true;
  }
  auto curve = function_of(from, *function, scale == 0 ? 1 : scale, lines.key("fct_IDf"), elastic->line());
  if (!curve) return false;
  mirror(*curve);
  foam.loading.push_back({0, curve->line, *std::move(curve)});
  return true;
}

/// Terms of the curve, and branches, that a card has.
constexpr std::size_t most_terms = 2;
using Terms = std::array<double, most_terms>;

/// A line of one number for each term; its number in the deck, absent after a fault.
std::optional<std::size_t> read_terms(long count, const char* name, const DeckUnit& unit, LawLines& lines,
                                      Terms& terms) {
  auto line = lines.next(Widths(most_terms, 20));
  if (!line) return std::nullopt;
  bool sound = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    terms[i] = line->number(i, lines.key(fmt::format("{}_{}", name, i + 1)), unit);
    sound = sound && terms[i] == terms[i];
  }
  return sound ? std::optional(line->line()) : std::nullopt;
}

/// The share of a sudden stress that lasts; absent where the solver takes no such ratios.
std::optional<double> lasting_share(const Terms& ratios, std::size_t line, const LawLines& of,
                                    MeasurementFaults& faults) {
  const auto [lowest, highest] = std::ranges::minmax(ratios);
  const double lasting = 1 - ratios[0] - ratios[1];
  if (lowest >= 0 && highest <= 1 && lasting > 0) return lasting;
  faults.add(line, of.key("gamma_i"), fmt::format("{:g}, {:g}", ratios[0], ratios[1]),
             "must each be in [0, 1], and their sum be less than 1");
  return std::nullopt;
}

void tell_of_law_62(long branches, long whole_stress, DeckFoam& foam) {
  if (branches == 0) {
    foam.assumptions.emplace_back("M = 0: there are no branches, so the foam loses no energy.");
    return;
  }
  if (whole_stress != 1)
    foam.differences.push_back(fmt::format(
        "Flag_Visc = {}: only the deviatoric stress relaxes in the solver; here the whole stress.",
        whole_stress));
  foam.differences.emplace_back(
      "The nominal stress relaxes here, in the solver the second Piola-Kirchhoff stress: the same for a "
      "sudden strain and after long times, not for a strain that changes in between.");
}

bool read_law_62(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  // Shares and lasting moduli are quotients of the deck's numbers, which are rounded. To so many digits those
  // of an exported card come back as they were, whatever its shares.
  constexpr int digits_of_quotients = 12;
  constexpr long given_as_lasting = 2;   // Flag_Rigi
  constexpr double longest_time = 1e15;  // s, that a card may have
  if (!read_density_line(lines, from, foam)) return false;
  auto flags = lines.next({20, 10, 10, 20, 10, 10});
  if (!flags) return false;
  tell_if_filled(*flags, 0, lines, "Nu", "the pad does not widen; 0 is taken", foam);
  tell_if_filled(*flags, 3, lines, "mu_max", "the viscosity has no limit", foam);
  const auto terms = count_in(*flags, 1, lines, "N", 1, from.faults, most_terms);
  const auto branches = count_in(*flags, 2, lines, "M", 0, from.faults, most_terms);
  const auto whole_stress = flags->whole(4, lines.key("Flag_Visc"));
  const auto rigidity = flags->whole(5, lines.key("Flag_Rigi"));
  if (!terms || !branches || !whole_stress || !rigidity) return false;

  Terms mu{}, alpha{1, 1}, gamma{}, tau{1, 1};
  if (!read_terms(*terms, "mu", from.units.stress, lines, mu) ||
      !read_terms(*terms, "alpha", {}, lines, alpha))
    return false;
  for (double& exponent : alpha)
    exponent = or_default(exponent, "An alpha_i is blank or 0, which the solver takes for 1.", foam);
  double lasting = 1;
  if (*branches > 0) {
    const auto line = read_terms(*branches, "gamma", {}, lines, gamma);
    if (!line || !read_terms(*branches, "tau", from.units.time, lines, tau)) return false;
    const auto share = lasting_share(gamma, *line, lines, from.faults);
    if (!share) return false;
    lasting = *share;
  }
  for (double& time : tau)
    if (time == 0) {
      time = longest_time;
      foam.assumptions.emplace_back("A tau_i is blank or 0: this branch does not relax, as in the solver.");
    }
  if (!lines.at_end()) {  // absent before the format of 2022
    auto ratios = lines.next(Widths(most_terms, 20));
    tell_if_filled(*ratios, 0, lines, "nu_1", "the pad does not widen; 0 is taken", foam);
    if (*terms > 1) tell_if_filled(*ratios, 1, lines, "nu_2", "the pad does not widen; 0 is taken", foam);
  }

  const auto quotient = [&](double value) {
    return lasting == 1 ? value : rounded_to(value, digits_of_quotients);
  };
  if (*rigidity != given_as_lasting)
    for (double& modulus : mu) modulus = quotient(modulus * lasting);
  foam.viscoelastic = ViscoelasticFoam{.first_modulus = mu[0],
                                       .first_exponent = alpha[0],
                                       .second_modulus = mu[1],
                                       .second_exponent = alpha[1],
                                       .first_share = quotient(gamma[0] / lasting),
                                       .first_time = tau[0],
                                       .second_share = quotient(gamma[1] / lasting),
                                       .second_time = tau[1]};
  tell_of_law_62(*branches, *whole_stress, foam);
  return true;
}

struct RadiossLaw {
  std::array<const char*, 2> names;
  bool crushable;
  bool (*read)(LawLines&, const RadiossSource&, DeckFoam&);
};
constexpr RadiossLaw radioss_laws[]{{{"LAW90", "LAW90"}, false, read_law_90},
                                    {{"LAW70", "FOAM_TAB"}, false, read_law_70},
                                    {{"LAW62", "VISC_HYP"}, false, read_law_62},
                                    {{"LAW33", "FOAM_PLAS"}, true, read_law_33}};

/// Whether the units that a line of the deck states, as codes or as numbers, are those of the system.
void compare_units(const DeckLine& line, const UnitSystem& system, MeasurementFaults& faults) {
  const std::array<std::array<std::string, 2>, 3> wanted{
      {{system.mass, "kg"}, {system.length, "m"}, {system.time, "s"}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (line.text.size() <= 20 * i) return;
    const std::string stated(without_blanks(line.text.substr(20 * i, 20)));
    if (stated.empty()) return;
    const ReadNumber number = read_deck_number(stated, {});
    double in_si = number.value;
    try {
      if (number.kind != NumberKind::number) in_si = to_si("1 " + stated, wanted[i][1]);
      if (std::abs(in_si / to_si("1 " + wanted[i][0], wanted[i][1]) - 1) < 1e-6) continue;
    } catch (const UnitError&) {
      return;  // no units after all
    }
    faults.add(line.number, "units", to_utf8(stated),
               fmt::format("is not {}, as the unit system {} has it", wanted[i][0], system.name));
  }
}

}  // namespace

std::vector<DeckFoam> read_radioss(std::string_view text, const UnitSystem& system, const DeckUnits& units,
                                   MeasurementFaults& faults) {
  const RadiossBlocks deck = radioss_blocks(text, faults);
  if (deck.begin && deck.begin->lines.size() > 2) compare_units(deck.begin->lines[2], system, faults);
  if (deck.foams.empty()) {
    std::string none =
        "holds no /MAT/LAW33 (FOAM_PLAS), /MAT/LAW62 (VISC_HYP), /MAT/LAW70 (FOAM_TAB) or /MAT/LAW90";
    for (std::size_t i = 0; i < deck.other_materials.size(); ++i)
      none += (i == 0 ? "; there are " : ", ") + deck.other_materials[i];
    faults.add(0, "", "", none);
  }
  std::vector<DeckFoam> foams;
  for (const DeckBlock& block : deck.foams) {
    const std::vector<std::string> parts = parts_of(block.keyword);
    const auto* const law = std::ranges::find_if(radioss_laws, [&](const RadiossLaw& each) {
      return parts[1] == each.names[0] || parts[1] == each.names[1];
    });
    DeckFoam foam;
    foam.card = std::string("/MAT/") + law->names[0];
    foam.id = number_in(parts, 2);
    foam.line = block.head.number;
    foam.crushable = law->crushable;
    if (const DeckBlock* const own = deck.units.find(number_in(parts, 3));
        own != nullptr && own->lines.size() > 1)
      compare_units(own->lines[1], system, faults);
    LawLines lines(block, foam.card, faults);
    foam.title = lines.title();
    if (law->read(lines, {deck, units, faults}, foam)) foams.push_back(std::move(foam));
  }
  return foams;
}

}  // namespace dashpad::input
