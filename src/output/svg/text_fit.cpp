#include "output/svg/text_fit.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "output/svg/svg.hpp"
#include "output/svg/text.hpp"

namespace dashpad::output {

namespace {

/// DejaVu Sans, which Linux often takes, is a tenth wider than Helvetica, and some of its letters are more.
constexpr double width_of_wide_font = 1.18;

/// Bytes of the characters at the beginning of valid UTF-8 that have room; at least one character's.
std::size_t bytes_within(std::string_view text, double size, double width) {
  double used = 0;
  std::size_t bytes = 0;
  while (bytes < text.size()) {
    std::size_t next = bytes + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xc0) == 0x80) ++next;
    used += text_room(text.substr(bytes, next - bytes), size);
    if (used > width && bytes > 0) break;
    bytes = next;
  }
  return bytes;
}

/// Whether a number stands before that blank, and behind it a unit.
bool parts_a_quantity(std::string_view text, std::size_t blank) {
  constexpr std::array<std::string_view, 38> units{
      "g",     "%",     "m",      "mm",     "m2",    "in2",    "s",     "ms",   "N",     "kN",
      "J",     "kg",    "deg",    "kPa",    "MPa",   "m/s",    "in",    "ft",   "lb",    "lbf",
      "psi",   "mph",   "km/h",   "ft/s",   "1/s",   "in·lbf", "N/m",   "N/mm", "kN/mm", "lbf/in",
      "kg/m2", "kg/m3", "lb/ft2", "lb/ft3", "kg/m³", "kJ/m³",  "kg/m²", "per"};
  if (blank == 0 || text[blank - 1] < '0' || text[blank - 1] > '9') return false;
  std::string_view next = text.substr(blank + 1);
  next = next.substr(0, next.find_first_of(" ,;:)"));
  if (next.ends_with('.')) next.remove_suffix(1);
  return std::ranges::find(units, next) != units.end();
}

/// Where the text may be broken, before that place; npos where nowhere.
std::size_t last_blank(std::string_view text, std::size_t end) {
  std::size_t blank = text.substr(0, end).rfind(' ');
  while (blank != std::string_view::npos && parts_a_quantity(text, blank))
    blank = text.substr(0, blank).rfind(' ');
  return blank;
}

}  // namespace

std::string quantities_whole(std::string_view text) {
  std::string whole;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ' && parts_a_quantity(text, i))
      whole += "\u00a0";
    else
      whole += text[i];
  }
  return whole;
}

double text_room(std::string_view text, double size) { return width_of_wide_font * text_width(text, size); }

std::string fitting(std::string_view text, double size, double width) {
  constexpr auto ellipsis = "…";
  std::string whole = readable(text);
  if (text_room(whole, size) <= width) return whole;
  whole.resize(bytes_within(whole, size, width - text_room(ellipsis, size)));
  return whole + ellipsis;
}

std::vector<std::string> lines_within(std::string_view text, double size, double width) {
  const std::string whole = readable(text);
  std::string_view rest = whole;
  std::vector<std::string> lines;
  while (!rest.empty()) {
    const std::size_t room = bytes_within(rest, size, width);
    const std::size_t space = room < rest.size() ? last_blank(rest, room + 1) : room;
    const bool breaks_at_space = room < rest.size() && space != std::string_view::npos && space > 0;
    lines.emplace_back(rest.substr(0, breaks_at_space ? space : room));
    rest.remove_prefix(breaks_at_space ? space + 1 : room);
  }
  return lines;
}

}  // namespace dashpad::output
