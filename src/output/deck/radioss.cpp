// Blocks of the Radioss starter: "/" in the first column begins a block, "#" a comment; but "#include" and
// "#enddata" are none, so a blank follows the "#".

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "dashpad/quantities/quantity.hpp"
#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

std::string function_block(const Curve& curve, int id) {
  return fmt::format("/FUNCT/{}\nDashpad {}: {}\n#                  X                   Y\n{}", id,
                     curve.name, caption(curve), number_rows(curve));
}

/// Mass, length and time as on the line of /BEGIN: by its codes, or, where one has none, as numbers of SI
/// units.
std::string unit_triple(const UnitSystem& units) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> codes{
      {{"kg", "kg"}, {"t", "Mg"}, {"mm", "mm"}, {"m", "m"}, {"ms", "ms"}, {"s", "s"}}};
  const std::array<std::pair<std::string, const char*>, 3> triple{
      {{units.mass, "kg"}, {units.length, "m"}, {units.time, "s"}}};
  std::string in_codes, in_numbers;
  bool has_codes = true;
  for (const auto& [unit, si_unit] : triple) {
    const auto* const code = std::ranges::find(codes, unit, &decltype(codes)::value_type::first);
    has_codes = has_codes && code != codes.end();
    if (has_codes) in_codes += fmt::format(" {}", code->second);
    in_numbers += fmt::format(" {:.15g}", to_si("1 " + unit, si_unit));
  }
  return has_codes ? in_codes : in_numbers;
}

}  // namespace

std::string radioss_text(const CurveFile& file) {
  std::string text;
  for (const std::string& line : heading(file)) text += comment("#", line);
  text += comment("#", "Unit triple, as in /BEGIN:" + unit_triple(file.units));
  text +=
      comment("#",
              "Radioss goes on beyond a function's ends along its first and last two points: end what uses "
              "it (Tstop) where it ends.");
  int id = checked_first_id(file);
  for (const FileCurve& of : file.curves) {
    text += "#\n" + comment("#", fmt::format("{}, function {}: {}", of.curve.name, id, of.remark));
    if (of.curve.exists()) text += function_block(in_units_of(file, of.curve), id);
    ++id;
  }
  return text;
}

}  // namespace dashpad::output
