// Blocks of the Radioss starter: "/" in the first column begins a block, "#" a comment; but "#include" and
// "#enddata" are none, so a blank follows the "#".

#include <fmt/format.h>

#include "report/deck_text.hpp"

namespace dashpad {

namespace {

std::string function_block(const Curve& curve, int id) {
  return fmt::format("/FUNCT/{}\nDashpad {}: {}\n#                  X                   Y\n{}", id,
                     curve.name, caption(curve), number_rows(curve));
}

}  // namespace

std::string radioss_text(const CurveFile& file) {
  std::string text;
  for (const std::string& line : heading(file)) text += comment("#", line);
  text += comment("#", "Unit triple, as in /BEGIN: " + file.units.radioss_begin);
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

}  // namespace dashpad
