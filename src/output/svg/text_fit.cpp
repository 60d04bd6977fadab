#include "output/svg/text_fit.hpp"

#include <cstddef>

#include "output/plot/text.hpp"
#include "output/svg/svg.hpp"

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

}  // namespace

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
    const std::size_t space = room < rest.size() ? rest.substr(0, room + 1).rfind(' ') : room;
    const bool breaks_at_space = room < rest.size() && space != std::string_view::npos && space > 0;
    lines.emplace_back(rest.substr(0, breaks_at_space ? space : room));
    rest.remove_prefix(breaks_at_space ? space + 1 : room);
  }
  return lines;
}

}  // namespace dashpad::output
