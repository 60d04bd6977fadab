#include "output/drawing/elements.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "output/plot/text.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Fonts that are wider than Helvetica have room too.
constexpr double allowance = 1.08;

}  // namespace

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

std::string path_element(std::string_view style, const std::vector<Place>& places, bool closed) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, path_data(places, closed));
}

std::string text_element(std::string_view style, Place place, std::string_view anchor,
                         std::string_view text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", style,
                     px(place.x), px(place.y), anchor, xml_text(text));
}

std::string fitted(std::string_view text, double width) {
  std::string line = readable(text);
  for (std::size_t length = 200; length > 1 && text_width(line, text_size) * allowance > width; --length)
    line = shortened(text, length);
  return line;
}

std::string unbroken(std::string text) {
  replace_all(text, " ", "\u00a0");
  return text;
}

std::vector<std::string> fitted_lines(std::string_view text, double width) {
  const std::string whole = readable(text);
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t begin = 0; begin <= whole.size();) {
    const std::size_t end = std::min(whole.find(' ', begin), whole.size());
    const std::string word = whole.substr(begin, end - begin);
    std::string longer = line;
    if (!longer.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && text_width(longer, text_size) * allowance > width) {
      lines.push_back(fitted(line, width));
      line = word;
    } else {
      line = std::move(longer);
    }
    begin = end + 1;
  }
  if (!line.empty()) lines.push_back(fitted(line, width));
  return lines;
}

}  // namespace dashpad::output
