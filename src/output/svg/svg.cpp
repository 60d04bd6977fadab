#include "output/svg/svg.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "output/svg/text.hpp"

namespace dashpad::output {

namespace {

/// Advance widths of Helvetica in thousandths of the size, from the space to the tilde (Adobe's metrics).
constexpr std::array<int, 95> widths{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
/// Of any other character, and of those from U+3000 on, most of which are as wide as high.
constexpr int usual_width = 600, full_width = 1000;

}  // namespace

std::string px(double value) {
  if (!std::isfinite(value)) return "0";
  const double rounded = std::round(value * 100) / 100;
  return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
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

}  // namespace dashpad::output
