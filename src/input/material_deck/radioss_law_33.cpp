// Radioss LAW33, FOAM_PLAS.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/radioss_laws.hpp"

namespace dashpad::input {

namespace {

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

}  // namespace

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

}  // namespace dashpad::input
