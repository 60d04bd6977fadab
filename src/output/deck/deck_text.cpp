#include "output/deck/deck_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/version.hpp"
#include "output/documents/basis.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string why_missing(const Curve& curve, const Summary& summary) {
  const bool ran = summary.status != Status::not_run;
  if (ran && !summary.release)
    return "not available: the impactor did not leave the pad (" + to_string(summary.status) + ")";
  return "not available: the " + curve.name + " curve has fewer than two points";
}

/// A fraction as a percentage of two digits, rounded up so that a bound does not look smaller than it is.
std::string bound(double fraction) {
  if (!(fraction > 0)) return "0 %";
  const double unit = std::pow(10, std::floor(std::log10(100 * fraction)) - 1);
  return fmt::format("{:.2g} %", std::ceil(100 * fraction / unit) * unit);
}

FileCurve file_curve(const std::string& name, const Solution& solution,
                     std::optional<std::size_t> max_points) {
  FileCurve of{curve(name, solution), ""};
  const std::size_t all = of.curve.size();
  if (!of.curve.exists()) {
    of.remark = why_missing(of.curve, solution.summary);
  } else if (max_points && all > *max_points) {
    ThinnedCurve few = thinned(of.curve, *max_points);
    double largest = 0;
    for (const double y : of.curve.y) largest = std::max(largest, std::abs(y));
    of.curve = std::move(few.curve);
    of.remark = fmt::format("{} of {} points, off by at most {} of the largest value", of.curve.size(), all,
                            bound(few.error / largest));
  } else {
    of.remark = fmt::format("{} points", all);
  }
  if (of.curve.exists() && of.curve.abscissa.meaning != "time")
    of.remark += "; valid for this impact only: a different nose or speed gives a different curve";
  return of;
}

/// The consequence of a flag for the curves.
std::string consequence(const Flag& flag, const Summary& summary) {
  if (flag.name == "TOLERANCE NOT MET")
    return std::string("; do not rely on these curves") +
           (summary.release ? "" : ", which end before the impact does");
  if (flag.name == "TIME LIMIT" || (flag.name == "BOTTOMED" && bottomed_on_rigid_support(summary)))
    return "; the curves end at that moment";
  if (flag.name == "BOTTOMED")
    return "; the force during that time is that of the support, so curves against penetration omit it";
  return "";
}

void convert(std::vector<double>& values, CurveAxis& axis, const CurveFile& file) {
  const bool in_g = file.acceleration_in_g && axis.si_unit == "m/s2";
  const double factor = in_g ? 1 / standard_gravity : value_in(file.units, 1, axis.si_unit);
  for (double& value : values) {
    value *= factor;
    if (!std::isfinite(value)) throw std::invalid_argument("curve: a number is not finite");
  }
  axis.si_unit = in_g ? "g" : unit_for(file.units, axis.si_unit);
}

}  // namespace

std::vector<std::string> flags_of(const Summary& summary) {
  std::vector<std::string> lines;
  for (const Flag& flag : flags(summary)) lines.push_back(flag.text + consequence(flag, summary));
  return lines;
}

CurveFile curve_file(const ImpactCase& impact, const Solution& solution,
                     const std::vector<std::string>& names, std::optional<std::size_t> max_points) {
  CurveFile file;
  file.title = impact.title;
  file.origin = case_lines(impact, unit_system("si"));
  file.flags = flags_of(solution.summary);
  for (const std::string& name : names) file.curves.push_back(file_curve(name, solution, max_points));
  return file;
}

std::string plain_ascii(std::string_view text) {
  std::string plain;
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte == 0x7f)
      plain += ' ';
    else if (byte >= 0xc0 || character == '&')
      plain += '?';
    else if (byte < 0x80)
      plain += character;  // the remaining bytes of a character are skipped
  }
  return plain;
}

std::string comment(std::string_view mark, std::string_view text, std::size_t width) {
  const std::size_t room = width - mark.size() - 1;
  std::string rest = plain_ascii(text);
  std::string lines;
  do {
    std::size_t end = rest.size();
    if (end > room) {
      const std::size_t blank = rest.rfind(' ', room);
      end = blank == std::string::npos || blank == 0 ? room : blank;
    }
    std::string line = fmt::format("{} {}", mark, rest.substr(0, end));
    line.erase(line.find_last_not_of(' ') + 1);
    lines += line + "\n";
    rest.erase(0, end);
    rest.erase(0, rest.find_first_not_of(' '));
  } while (!rest.empty());
  return lines;
}

std::vector<std::string> heading(const CurveFile& file) {
  const UnitSystem& units = file.units;
  std::vector<std::string> lines{fmt::format("Dashpad {} (commit {}): curves of an impact on a foam pad",
                                             version(), build_facts().git_commit),
                                 "Case: " + (file.title.empty() ? "untitled" : file.title)};
  lines.insert(lines.end(), file.origin.begin(), file.origin.end());
  lines.push_back(fmt::format(
      "Units: {} (mass {}, length {}, time {}); velocity {}, acceleration {}, force {}, "
      "stress {}, energy {}",
      units.name, units.mass, units.length, units.time, units.speed,
      file.acceleration_in_g ? "g" : units.acceleration, units.force, units.pressure, units.energy));
  lines.emplace_back(
      "Signs: force and penetration are positive in compression; velocity and motion are positive towards "
      "the pad; acceleration is negative while the pad pushes");
  for (const std::string& flag : file.flags) lines.push_back("FLAG: " + flag);
  return lines;
}

std::string number_field(double value) {
  constexpr std::size_t width = 20;
  if (value == 0) value = 0;  // without a sign
  std::string text;
  for (int digits = 13; text.empty() || text.size() >= width; --digits)
    text = fmt::format("{:.{}E}", value, digits);
  return fmt::format("{:>{}}", text, width);
}

std::string number_rows(const Curve& curve) {
  std::string rows;
  for (std::size_t i = 0; i < curve.size(); ++i)
    rows += number_field(curve.x[i]) + number_field(curve.y[i]) + "\n";
  return rows;
}

Curve in_units_of(const CurveFile& file, const Curve& curve) {
  Curve converted = curve;
  if (curve.x.size() != curve.y.size()) throw std::invalid_argument("curve: x and y differ in length");
  convert(converted.x, converted.abscissa, file);
  convert(converted.y, converted.ordinate, file);
  // Compares numbers as written, since two may differ only in digits that a field does not hold.
  const auto written = [](double x) { return std::strtod(number_field(x).c_str(), nullptr); };
  const auto falls_back = [&](double a, double b) { return written(b) <= written(a); };
  if (std::ranges::adjacent_find(converted.x, falls_back) != converted.x.end())
    throw std::invalid_argument("curve: x is not strictly increasing");
  return converted;
}

std::string define_curve(const std::string& title, int id, std::string_view axes, const std::string& points) {
  return fmt::format(
      "*DEFINE_CURVE_TITLE\n{}\n"
      "$     LCID      SIDR       SFA       SFO      OFFA      OFFO    DATTYP\n"
      "{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n{}\n{}",
      title, id, 0, "1.0", "1.0", "0.0", "0.0", 0, axes, points);
}

std::string caption(const Curve& curve) {
  return fmt::format("{} ({}) against {} ({})", curve.ordinate.meaning, curve.ordinate.si_unit,
                     curve.abscissa.meaning, curve.abscissa.si_unit);
}

int checked_first_id(const CurveFile& file) {
  const auto count = static_cast<int>(std::min(file.curves.size(), std::size_t{highest_curve_id}));
  if (file.first_id < 1 || file.first_id > highest_curve_id - std::max(count, 1) + 1)
    throw std::invalid_argument(fmt::format("first curve number {}: all curve numbers must be from 1 to {}",
                                            file.first_id, highest_curve_id));
  return file.first_id;
}

}  // namespace dashpad::output
