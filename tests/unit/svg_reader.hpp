#pragma once
/// What tests read in an SVG.

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shared/temporary_folder.hpp"

namespace dashpad::test {

/// Whether Python's parser accepts the text.
inline bool is_well_formed(const std::string& xml) {
  TemporaryFolder folder;
  const auto file = folder.path() / "picture.svg";
  std::ofstream{file, std::ios::binary} << xml;
  const std::string command =
      "python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' '" + file.string() + "'";
  return std::system(command.c_str()) == 0;
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
  for (const std::string& element : all_between(svg, "<text class=\"dp-tick ", "</text>"))
    numbers.push_back(element.substr(element.find('>') + 1));
  return numbers;
}

/// The "d" of the paths with that class.
inline std::vector<std::string> paths(const std::string& svg, const std::string& class_name) {
  std::vector<std::string> found;
  for (const std::string& element : all_between(svg, "<path class=\"" + class_name, "/>"))
    found.push_back(all_between(element, " d=\"", "\"").at(0));
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
