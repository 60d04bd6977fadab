// Curves as text for LS-DYNA, for Radioss, and as CSV.

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

/// "time_mm_per_ms2" for "time" in "mm/ms2".
std::string column_name(const CurveAxis& axis) {
  std::string name = axis.meaning + "_";
  for (const char character : axis.si_unit) name += character == '/' ? "_per_" : std::string(1, character);
  return name;
}

std::string function_block(const Curve& curve, int id) {
  return fmt::format("/FUNCT/{}\nDashpad {}: {}\n#                  X                   Y\n{}", id,
                     curve.name, caption(curve), number_rows(curve));
}

/// Mass, length and time as in the line of /BEGIN: by its codes or, if one has none, as numbers of SI units.
std::string unit_triple(const UnitSystem& units) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> codes{
      {{"kg", "kg"}, {"t", "Mg"}, {"g", "g"}, {"mm", "mm"}, {"m", "m"}, {"ms", "ms"}, {"s", "s"}}};
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

std::string curve_csv(const CurveFile& file) {
  if (file.curves.size() != 1) throw std::invalid_argument("a CSV file can hold only one curve");
  const FileCurve& file_curve = file.curves.front();
  const Curve curve = in_units_of(file, file_curve.curve);
  fmt::memory_buffer text;
  for (const std::string& line : heading(file)) text.append(comment("#", line));
  text.append(comment("#", file_curve.curve.name + ": " + file_curve.remark));
  fmt::format_to(std::back_inserter(text), "{},{}\n", column_name(curve.abscissa),
                 column_name(curve.ordinate));
  for (std::size_t i = 0; i < curve.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", curve.x[i], curve.y[i]);
  return fmt::to_string(text);
}

std::string ls_dyna_text(const CurveFile& file) {
  constexpr std::size_t width = 80;
  std::string text = "*KEYWORD\n";
  for (const std::string& line : heading(file)) text += comment("$", line, width);
  text += comment("$", "LS-DYNA resamples curves at LCINT equal intervals (*CONTROL_SOLUTION; default 100).");
  text += plain_ascii("$ Dashpad: " + file.title).substr(0, width) + "\n";
  int id = checked_first_id(file);
  for (const FileCurve& file_curve : file.curves) {
    text +=
        "$\n" +
        comment("$", fmt::format("{}, curve {}: {}", file_curve.curve.name, id, file_curve.remark), width);
    if (file_curve.curve.exists()) {
      const Curve curve = in_units_of(file, file_curve.curve);
      text += define_curve(fmt::format("Dashpad {}: {}", curve.name, caption(curve)), id,
                           "$                 A1                  O1", number_rows(curve));
    }
    ++id;
  }
  return text + "*END\n";
}

std::string radioss_text(const CurveFile& file) {
  std::string text;
  for (const std::string& line : heading(file)) text += comment("#", line);
  text += comment("#", "Units of mass, length and time, as in /BEGIN:" + unit_triple(file.units));
  text +=
      comment("#",
              "Beyond its ends, Radioss extrapolates a function through its first or last two points; stop "
              "whatever uses the function (Tstop) where it ends.");
  int id = checked_first_id(file);
  for (const FileCurve& file_curve : file.curves) {
    text += "#\n" +
            comment("#", fmt::format("{}, function {}: {}", file_curve.curve.name, id, file_curve.remark));
    if (file_curve.curve.exists()) text += function_block(in_units_of(file, file_curve.curve), id);
    ++id;
  }
  return text;
}

}  // namespace dashpad::output
