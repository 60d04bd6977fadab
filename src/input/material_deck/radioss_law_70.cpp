// Radioss LAW70, FOAM_TAB.

#include <utility>

#include <fmt/format.h>

#include "input/material_deck/radioss_laws.hpp"

namespace dashpad::input {

namespace {

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

}  // namespace

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

}  // namespace dashpad::input
