// Conversion of the numbers of Radioss LAW33 (FOAM_PLAS), LAW62 (VISC_HYP), LAW70 (FOAM_TAB) and LAW90.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/radioss.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

/// Largest number of terms, and of branches, on a card.
constexpr std::size_t max_terms = 2;
using Terms = std::array<double, max_terms>;

/// Reads a line of one number per term. Returns the line's number; absent after a fault.
std::optional<std::size_t> read_terms(long count, const char* name, const DeckUnit& unit, LawLines& lines,
                                      Terms& terms) {
  auto line = lines.next(Widths(max_terms, 20));
  if (!line) return std::nullopt;
  bool sound = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    terms[i] = line->number(i, lines.key(fmt::format("{}_{}", name, i + 1)), unit);
    sound = sound && terms[i] == terms[i];
  }
  return sound ? std::optional(line->line()) : std::nullopt;
}

/// The lasting share of a sudden stress; absent for invalid ratios.
std::optional<double> lasting_share(const Terms& ratios, std::size_t line, const LawLines& law_lines,
                                    MeasurementFaults& faults) {
  const auto [lowest, highest] = std::ranges::minmax(ratios);
  const double lasting = 1 - ratios[0] - ratios[1];
  if (lowest >= 0 && highest <= 1 && lasting > 0) return lasting;
  faults.add(line, law_lines.key("gamma_i"), fmt::format("{:g}, {:g}", ratios[0], ratios[1]),
             "must each be from 0 to 1, and their sum must be less than 1");
  return std::nullopt;
}

void tell_of_law_62(long branches, long whole_stress, DeckFoam& foam) {
  if (branches == 0) {
    foam.assumptions.emplace_back("M = 0: there are no branches, so the foam loses no energy.");
    return;
  }
  if (whole_stress != 1)
    foam.differences.push_back(fmt::format(
        "Flag_Visc = {}: in the solver only the deviatoric stress relaxes; in Dashpad the whole stress does.",
        whole_stress));
  foam.differences.emplace_back(
      "Here the nominal stress relaxes; in the solver, the second Piola-Kirchhoff stress does. They agree "
      "for a sudden strain and after a long time, but not for a strain that changes gradually.");
}

/// Points of |A + B (1 + C gamma)| at gamma = -strain, until almost no air is left.
DeckCurve yield_formula(double a, double b, double c, double phi, std::size_t line) {
  constexpr int count = 40;
  DeckCurve curve{"yield stress A + B (1 + C gamma)", line};
  for (int i = 0; i <= count; ++i) {
    const double e = 0.95 * (1 - phi) * i / count;
    curve.add(e, std::abs(a + b * (1 - c * e)), line);
  }
  return curve;
}

/// Converts gamma = V/V0 - 1, negative in compression, to strain.
void mirror(DeckCurve& curve) {
  for (double& strain : curve.strain) strain = strain == 0 ? 0 : -strain;
  curve.reverse();
}

/// Sets the unloading by Iflag: at 4, as in LAW90, Shape and Hys lessen the whole stress.
void settle_unloading(long flag, double shape, double factor, std::vector<DeckRateCurve> ways_back,
                      DeckFoam& foam) {
  if (flag >= 3) {
    foam.unloading_shape = or_one(shape, "Shape", foam);
    foam.unloading_factor = or_one(factor, "Hys", foam, ", which the solver treats as 1 (no energy loss)");
    if (flag == 3)
      foam.differences.emplace_back(
          "Iflag = 3: the solver reduces only the shear stresses; Dashpad reduces the whole stress.");
  } else if (ways_back.empty()) {
    foam.assumptions.emplace_back(
        "There is no unloading function, so the foam unloads along the curve for the lowest rate.");
  } else {
    foam.unloading = std::move(ways_back.front().curve);
    if (ways_back.size() > 1)
      foam.differences.emplace_back("Only the first unloading function, the slowest, was used.");
    foam.differences.emplace_back(
        "Here the unloading function applies to unloading from the last strain and, for smaller strains, is "
        "scaled with the work done; the solver always drops to the same curve.");
  }
}

}  // namespace

bool read_law_62(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  // Shares and lasting moduli are quotients of rounded numbers. With so many digits, those of an exported
  // card are restored exactly.
  constexpr int digits_of_quotients = 12;
  constexpr long given_as_lasting = 2;   // Flag_Rigi
  constexpr double longest_time = 1e15;  // s
  const auto flags = lines.next(deck::law_62_flags);
  if (!flags) return false;
  const auto terms = lines.count(*flags, "N", 1, max_terms),
             branches = lines.count(*flags, "M", 0, max_terms);
  if (!terms || !branches || !flags->are_sound()) return false;

  Terms mu{}, alpha{1, 1}, gamma{}, tau{1, 1};
  if (!read_terms(*terms, "mu", from.units.stress, lines, mu) ||
      !read_terms(*terms, "alpha", {}, lines, alpha))
    return false;
  for (double& exponent : alpha) exponent = or_one(exponent, "An alpha_i", foam);
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
      foam.assumptions.emplace_back(
          "A tau_i is blank or 0, so this branch does not relax, as in the solver.");
    }
  if (!lines.at_end()) {  // missing before the format of 2022
    constexpr DeckField ratios[]{{"nu_1", Content::number, deck::zero_is_taken, 20},
                                 {"nu_2", Content::number, deck::zero_is_taken, 20}};
    lines.next(DeckCard(ratios).first(static_cast<std::size_t>(*terms)));
  }

  const auto quotient = [&](double value) {
    return lasting == 1 ? value : rounded_to(value, digits_of_quotients);
  };
  if (flags->whole("Flag_Rigi") != given_as_lasting)
    for (double& modulus : mu) modulus = quotient(modulus * lasting);
  foam.viscoelastic = ViscoelasticFoam{.first_modulus = mu[0],
                                       .first_exponent = alpha[0],
                                       .second_modulus = mu[1],
                                       .second_exponent = alpha[1],
                                       .first_share = quotient(gamma[0] / lasting),
                                       .first_time = tau[0],
                                       .second_share = quotient(gamma[1] / lasting),
                                       .second_time = tau[1]};
  tell_of_law_62(*branches, flags->whole("Flag_Visc"), foam);
  return true;
}

bool read_law_33(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  const auto elastic = lines.next(deck::law_33_elastic), gas = lines.next(deck::law_33_gas),
             yield = lines.next(deck::law_33_yield);
  if (!elastic || !gas || !yield) return false;
  foam.modulus = (*elastic)("E");
  const double gamma_0 = (*gas)("Gamma_0");
  foam.air = {(*gas)("P0"), (*gas)("Phi")};
  if (std::isnan((*elastic)("fct_IDf")) || std::isnan((*elastic)("Fscale")) || std::isnan(gamma_0) ||
      !yield->are_sound())
    return false;
  if (gamma_0 != 0) {
    from.faults.add(gas->line, lines.key("Gamma_0"), fmt::format("{:g}", gamma_0),
                    "must be 0; foam that is already compressed at the start is not read");
    return false;
  }
  if (!(foam.air.pressure >= 0 && foam.air.relative_density >= 0 && foam.air.relative_density < 1)) {
    from.faults.add(gas->line, lines.key("P0"), "",
                    "must not be negative, and Phi must be at least 0 and less than 1");
    return false;
  }
  if (foam.air.pressure > 0)
    foam.differences.emplace_back(
        "Here the air pressure is part of the crush curve and does not push the crushed foam back.");
  const long function = elastic->whole("fct_IDf");
  if (function == 0) {
    DeckCurve curve =
        yield_formula((*yield)("A"), (*yield)("B"), (*yield)("C"), foam.air.relative_density, yield->line);
    foam.assumptions.push_back(fmt::format(
        "The yield stress |A + B (1 + C gamma)| was converted to points up to a strain of {:.3g}.",
        curve.strain.back()));
    foam.loading.push_back({0, yield->line, std::move(curve)});
    return true;
  }
  auto curve = lines.function(function, (*elastic)("Fscale"), "fct_IDf", elastic->line);
  if (!curve) return false;
  if (!curve->strain.empty() && std::ranges::min(curve->strain) >= 0 && std::ranges::max(curve->strain) > 0) {
    from.faults.add(
        curve->line, curve->name, "",
        "has all its points at positive strains, which are tensile in LAW33; compression is negative");
    return false;
  }
  mirror(*curve);
  foam.loading.push_back({0, curve->line, *std::move(curve)});
  return true;
}

bool read_law_70(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  const auto elastic = lines.next(deck::law_70_elastic), flags = lines.next(deck::law_70_flags);
  if (!elastic || !flags) return false;
  foam.modulus = (*elastic)("E0");
  const auto count = lines.count(*flags, "NL", 1), count_back = lines.count(*flags, "NuL", 0);
  if (!count || !count_back || std::isnan((*flags)("Iflag"))) return false;
  const long flag = flags->whole("Iflag");
  if (flag < 0 || flag > 4) {
    from.faults.add(flags->line, lines.key("Iflag"), fmt::format("{}", flag), "must be from 0 to 4");
    return false;
  }
  std::vector<DeckRateCurve> ways_back;
  if (!lines.rows(*count, foam.loading) || !lines.rows(*count_back, ways_back)) return false;
  settle_unloading(flag, (*flags)("Shape"), (*flags)("Hys"), std::move(ways_back), foam);
  return true;
}

bool read_law_90(LawLines& lines, const RadiossSource&, DeckFoam& foam) {
  const auto elastic = lines.next(deck::law_90_elastic), flags = lines.next(deck::law_90_flags);
  if (!elastic || !flags) return false;
  foam.modulus = (*elastic)("E0");
  settle_unloading(4, (*flags)("Shape"), (*flags)("Hys"), {}, foam);
  tell_of_exponent((*flags)("Alpha"), "Alpha", foam);
  const auto count = lines.count(*flags, "NL", 1);
  return count && lines.rows(*count, foam.loading);
}

}  // namespace dashpad::input
