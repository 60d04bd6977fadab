// *KEYWORD input of LS-DYNA: lines of 80 columns; "*" in the first column begins a keyword, "$" a comment.

#include <fmt/format.h>

#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

std::string define_curve(const Curve& curve, int id) {
  // Fields of 10 columns, then of 20. SIDR 0: for the transient analysis; scales 1, offsets 0; DATTYP 0: a
  // curve over time, or of force over displacement.
  return fmt::format(
      "*DEFINE_CURVE_TITLE\nDashpad {}: {}\n"
      "$     LCID      SIDR       SFA       SFO      OFFA      OFFO    DATTYP\n"
      "{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n"
      "$                 A1                  O1\n{}",
      curve.name, caption(curve), id, 0, "1.0", "1.0", "0.0", "0.0", 0, number_rows(curve));
}

}  // namespace

std::string ls_dyna_text(const CurveFile& file) {
  constexpr std::size_t width = 80;
  std::string text = "*KEYWORD\n";
  for (const std::string& line : heading(file)) text += comment("$", line, width);
  text +=
      comment("$", "LS-DYNA resamples a curve at LCINT equal steps (*CONTROL_SOLUTION; 100 unless told).");
  text += plain_ascii("$ Dashpad: " + file.title).substr(0, width) + "\n";
  int id = checked_first_id(file);
  for (const FileCurve& of : file.curves) {
    text += "$\n" + comment("$", fmt::format("{}, curve {}: {}", of.curve.name, id, of.remark), width);
    if (of.curve.exists()) text += define_curve(in_units_of(file, of.curve), id);
    ++id;
  }
  return text + "*END\n";
}

}  // namespace dashpad::output
