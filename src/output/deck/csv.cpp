// Two columns for everything else.

#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "output/deck/deck_text.hpp"

namespace dashpad::output {

namespace {

/// "time" in "mm/ms2": "time_mm_per_ms2".
std::string column_name(const CurveAxis& axis) {
  std::string name = axis.meaning + "_";
  for (const char character : axis.si_unit) name += character == '/' ? "_per_" : std::string(1, character);
  return name;
}

}  // namespace

std::string curve_csv(const CurveFile& file) {
  if (file.curves.size() != 1) throw std::invalid_argument("a CSV file holds one curve");
  const FileCurve& of = file.curves.front();
  const Curve curve = in_units_of(file, of.curve);
  fmt::memory_buffer text;
  for (const std::string& line : heading(file)) text.append(comment("#", line));
  text.append(comment("#", of.curve.name + ": " + of.remark));
  fmt::format_to(std::back_inserter(text), "{},{}\n", column_name(curve.abscissa),
                 column_name(curve.ordinate));
  for (std::size_t i = 0; i < curve.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", curve.x[i], curve.y[i]);
  return fmt::to_string(text);
}

}  // namespace dashpad::output
