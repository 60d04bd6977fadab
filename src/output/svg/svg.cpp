#include "output/svg/svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Advance widths of Helvetica in thousandths of the size, from the space to the tilde (Adobe's metrics).
constexpr std::array<int, 95> widths{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
/// Widths of all other characters: those from U+3000 on are mostly as wide as high.
constexpr int usual_width = 600, full_width = 1000;
/// DejaVu Sans, which Linux often takes, is a tenth wider than Helvetica, and some of its letters are more.
constexpr double width_of_wide_font = 1.18;

constexpr auto ellipsis = "…";

/// Width of a text in px in a sans-serif font of that size, which common ones share within a few per cent.
double text_width(std::string_view text, double size) {
  int sum = 0;
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte >= 0x20 && byte < 0x7f)
      sum += widths[byte - 0x20];
    else if ((byte & 0xc0) != 0x80)  // the first of a character's bytes
      sum += byte >= 0xe3 ? full_width : usual_width;
  }
  return sum * size / 1000;
}

/// Whether a character is a control, one of C1 or a separator of lines or paragraphs.
bool is_control(std::string_view character) {
  const auto last = static_cast<unsigned char>(character.back());
  if (character.size() == 1) return last < 0x20 || last == 0x7f;
  if (character.size() == 2) return character[0] == '\xc2' && last < 0xa0;
  return character == "\u2028" || character == "\u2029";
}

/// U+FFFE and U+FFFF, which XML forbids.
bool is_no_character(std::string_view character) {
  return character == "\xef\xbf\xbe" || character == "\xef\xbf\xbf";
}

/// Bytes of the characters at the beginning of valid UTF-8 that have room; at least one character's.
std::size_t bytes_within(std::string_view text, double size, double width) {
  double used = 0;
  std::size_t bytes = 0;
  while (bytes < text.size()) {
    const std::size_t length = character_length(text.substr(bytes));
    used += text_room(text.substr(bytes, length), size);
    if (used > width && bytes > 0) break;
    bytes += length;
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

/// The last blank before `end` at which the text may be broken; npos if there is none.
std::size_t last_blank(std::string_view text, std::size_t end) {
  std::size_t blank = text.substr(0, end).rfind(' ');
  while (blank != std::string_view::npos && parts_a_quantity(text, blank))
    blank = text.substr(0, blank).rfind(' ');
  return blank;
}

}  // namespace

std::string px(double value) {
  if (!std::isfinite(value)) return "0";
  const double rounded = std::round(value * 100) / 100;
  return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
}

std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view character = text.substr(0, character_length(text));
    if (character.empty() || is_no_character(character))
      result += "\xef\xbf\xbd";
    else if (is_control(character))
      result += ' ';
    else
      result += character;
    text.remove_prefix(std::max<std::size_t>(character.size(), 1));
  }
  return result;
}

std::string shortened(std::string_view text, std::size_t length) {
  std::string result = readable(text);
  if (width_of(result) <= length) return result;
  std::size_t bytes = 0;
  for (; length > 1; --length) bytes += character_length(std::string_view(result).substr(bytes));
  return result.substr(0, bytes) + ellipsis;
}

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char character : readable(text)) {
    switch (character) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += character;
    }
  }
  return result;
}

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

std::string colour_on_scale(std::span<const Colour> stops, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double part = place - static_cast<double>(below);
  const auto mixed = [&](std::size_t i) {
    return static_cast<int>(std::lround(std::lerp(stops[below][i], stops[below + 1][i], part)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

std::string line_element(std::string_view style, Place from, Place to) {
  return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", style, px(from.x),
                     px(from.y), px(to.x), px(to.y));
}

std::string rectangle_element(std::string_view style, double x, double y, double width, double height) {
  return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", style, px(x),
                     px(y), px(width > 0 ? width : 0), px(height > 0 ? height : 0));
}

std::string path_data(const std::vector<Place>& places, bool closed) {
  std::string data;
  for (const Place& place : places)
    data += fmt::format("{}{} {}", data.empty() ? "M" : "L", px(place.x), px(place.y));
  return closed ? data + "Z" : data;
}

std::string path_element(std::string_view style, std::string_view data) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, data);
}

std::string path_element(std::string_view style, const std::vector<Place>& places, bool closed) {
  return path_element(style, path_data(places, closed));
}

std::string text_element(std::string_view style, Place place, std::string_view text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style, px(place.x), px(place.y),
                     xml_text(text));
}

std::string text_elements(std::string_view style, Place first, double distance,
                          const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += text_element(style, first, line);
    first.y += distance;
  }
  return text;
}

std::string text_element(std::string_view style, Place place, std::string_view anchor,
                         std::string_view text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", style,
                     px(place.x), px(place.y), anchor, xml_text(text));
}

}  // namespace dashpad::output
