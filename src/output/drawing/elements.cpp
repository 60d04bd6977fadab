#include "output/drawing/elements.hpp"

#include <fmt/format.h>

#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

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

std::string unbroken(std::string text) {
  replace_all(text, " ", "\u00a0");
  return text;
}

}  // namespace dashpad::output
