// Radioss LAW90.

#include <fmt/format.h>

#include "input/material_deck/radioss_laws.hpp"

namespace dashpad::input {

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

}  // namespace dashpad::input
