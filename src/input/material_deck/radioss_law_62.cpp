// Radioss LAW62, VISC_HYP.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/material_deck/radioss_laws.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

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

}  // namespace

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

}  // namespace dashpad::input
