#pragma once
/// Reads an SVG strictly, as far as Dashpad writes any: tags, attributes in double quotes, the five entities.

#include <cctype>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dashpad::test {

struct SvgElement {
  std::string name;
  std::map<std::string, std::string> attributes = {};
  std::string text = {};                    ///< directly inside, entities as they are written
  std::vector<std::size_t> ancestors = {};  ///< the outermost first

  [[nodiscard]] double number(const std::string& attribute) const {
    return std::stod(attributes.at(attribute));
  }
  [[nodiscard]] bool has(const std::string& attribute, std::string_view value) const {
    const auto found = attributes.find(attribute);
    return found != attributes.end() && found->second == value;
  }
  /// Whether that is one of its classes.
  [[nodiscard]] bool is_of(std::string_view class_name) const {
    const auto classes = attributes.find("class");
    if (classes == attributes.end()) return false;
    std::istringstream words{classes->second};
    for (std::string word; words >> word;)
      if (word == class_name) return true;
    return false;
  }
};

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("no well-formed SVG: " + what);
}

/// UTF-8, and of that only what XML admits.
inline void require_characters(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i++]);
    const int following = byte < 0x80 ? 0 : byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : 1;
    require(byte < 0x80 || (byte >= 0xc2 && byte <= 0xf4), "byte that begins no character");
    char32_t code = following == 0 ? byte : byte & (0x3f >> following);
    for (int k = 0; k < following; ++k) {
      require(i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80, "character cut short");
      code = code << 6 | (static_cast<unsigned char>(text[i++]) & 0x3f);
    }
    const char32_t least = following == 3 ? 0x10000 : following == 2 ? 0x800 : 0;
    require(code >= least && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) && code != 0xfffe &&
                code != 0xffff,
            "character that XML does not admit");
  }
}

inline void require_text(std::string_view text) {
  require_characters(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    require(byte >= 0x20 || text[i] == '\n', "control character");
    require(text[i] != '<' && text[i] != '>', "bare angle bracket");
    if (text[i] != '&') continue;
    const std::string_view entity = text.substr(i, text.find(';', i) - i);
    require(entity == "&amp" || entity == "&lt" || entity == "&gt" || entity == "&quot" || entity == "&#39",
            "entity " + std::string(entity));
  }
}

/// All elements in the order of their first tags. Throws std::runtime_error for what is not well-formed.
inline std::vector<SvgElement> svg_elements(const std::string& svg) {
  std::vector<SvgElement> elements;
  std::vector<std::size_t> open;
  std::size_t at = 0;
  while (at < svg.size()) {
    const std::size_t tag = svg.find('<', at);
    const std::string_view between = std::string_view(svg).substr(at, tag - at);
    require_text(between);
    if (!open.empty()) elements[open.back()].text += between;
    if (open.empty()) require(between.find_first_not_of('\n') == std::string_view::npos, "text outside");
    if (tag == std::string::npos) break;
    const std::size_t end = svg.find('>', tag);
    require(end != std::string::npos, "open tag");
    std::string inside = svg.substr(tag + 1, end - tag - 1);
    at = end + 1;
    if (inside.starts_with('/')) {
      require(!open.empty() && elements[open.back()].name == inside.substr(1), "closed " + inside);
      open.pop_back();
      continue;
    }
    const bool is_empty = inside.ends_with('/');
    if (is_empty) inside.pop_back();
    std::size_t place = inside.find(' ');
    SvgElement element{.name = inside.substr(0, place), .ancestors = open};
    while (place < inside.size()) {
      const std::size_t equals = inside.find("=\"", place);
      const std::size_t quote = inside.find('"', equals + 2);
      require(equals != std::string::npos && quote != std::string::npos, "attribute in " + inside);
      const std::string value = inside.substr(equals + 2, quote - equals - 2);
      require_text(value);
      require(element.attributes.emplace(inside.substr(place + 1, equals - place - 1), value).second,
              "attribute twice in " + inside);
      place = quote + 1;
      require(place == inside.size() || inside[place] == ' ', "space in " + inside);
    }
    require(!open.empty() || elements.empty(), "two roots");
    elements.push_back(std::move(element));
    if (!is_empty) open.push_back(elements.size() - 1);
  }
  require(open.empty() && !elements.empty(), "end");
  return elements;
}

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (auto place = text.find(part); place != std::string::npos; place = text.find(part, place + 1)) ++result;
  return result;
}

/// The text between each `begin` and the next `end`.
inline std::vector<std::string> all_between(const std::string& text, const std::string& begin,
                                            const std::string& end) {
  std::vector<std::string> found;
  for (auto place = text.find(begin); place != std::string::npos; place = text.find(begin, place)) {
    place += begin.size();
    found.push_back(text.substr(place, text.find(end, place) - place));
  }
  return found;
}

/// What stands on the axes, x before y.
inline std::vector<std::string> numbers_on_axes(const std::string& svg) {
  std::vector<std::string> numbers;
  for (const SvgElement& element : svg_elements(svg))
    if (element.name == "text" && element.is_of("dp-tick")) numbers.push_back(element.text);
  return numbers;
}

/// The "d" of the paths with that class.
inline std::vector<std::string> paths(const std::string& svg, std::string_view class_name) {
  std::vector<std::string> found;
  for (const SvgElement& element : svg_elements(svg))
    if (element.name == "path" && element.is_of(class_name)) found.push_back(element.attributes.at("d"));
  return found;
}

/// The numbers of a path whose commands are capital letters, or z.
inline std::vector<double> numbers_of(std::string path) {
  for (char& character : path)
    if (std::isalpha(static_cast<unsigned char>(character)) != 0) character = ' ';
  std::istringstream stream{path};
  std::vector<double> numbers;
  for (double number = 0; stream >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace dashpad::test
