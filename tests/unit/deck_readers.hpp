#pragma once
/// Readers of decks, written from descriptions of the formats: Altair's pages on /FUNCT, on the syntax of the
/// Radioss starter and on *DEFINE_CURVE, and for the columns of that card, decks that others have published.
/// They throw where a line does not fit.

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace dashpad::test {

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What Fortran reads from a field: blanks count for nothing; an empty field is 0.
inline double field(const std::string& line, std::size_t first, std::size_t width) {
  const std::string text = first < line.size() ? line.substr(first, width) : "";
  if (text.find_first_not_of(' ') == std::string::npos) return 0;
  std::size_t used = 0;
  const double value = std::stod(text, &used);
  if (text.find_first_not_of(' ', used) != std::string::npos) throw std::runtime_error("no number: " + text);
  return value;
}

struct ReadCurve {
  int id = 0;
  std::string title;
  std::vector<double> card;  ///< SIDR SFA SFO OFFA OFFO DATTYP
  std::vector<double> x, y;
};

/// Two fields of 20 columns.
inline void read_point(const std::string& line, ReadCurve& curve) {
  if (line.size() > 40) throw std::runtime_error("too long: " + line);
  curve.x.push_back(field(line, 0, 20));
  curve.y.push_back(field(line, 20, 20));
}

struct KeywordFile {
  std::vector<std::string> keywords;
  std::string title;
  std::vector<ReadCurve> curves;
};

/// A keyword is "*" in the first column and a comment "$"; cards follow until the next keyword.
inline KeywordFile read_keywords(const std::string& text) {
  KeywordFile file;
  std::size_t card = 0;
  for (const std::string& line : lines_of(text)) {
    if (line.size() > 80) throw std::runtime_error("longer than 80: " + line);
    if (line.starts_with("$")) continue;
    if (line.starts_with("*")) {
      file.keywords.push_back(line);
      card = 0;
      if (line == "*END") break;
      if (line.starts_with("*DEFINE_CURVE")) file.curves.emplace_back();
      continue;
    }
    ++card;
    const std::string& keyword = file.keywords.at(file.keywords.size() - 1);
    if (keyword == "*DEFINE_CURVE_TITLE" && card == 1) {
      file.curves.back().title = line;
    } else if (keyword == "*DEFINE_CURVE_TITLE" && card == 2) {
      file.curves.back().id = static_cast<int>(field(line, 0, 10));
      for (std::size_t i = 1; i < 7; ++i) file.curves.back().card.push_back(field(line, 10 * i, 10));
    } else if (keyword == "*DEFINE_CURVE_TITLE") {
      read_point(line, file.curves.back());
    } else {
      throw std::runtime_error("a line that belongs nowhere: " + line);
    }
  }
  return file;
}

/// A block begins with "/" in the first column; "#" and "$" are comments but for "#include", "#enddata" and
/// "#RADIOSS"; below /FUNCT/id stand a title and the points.
inline std::vector<ReadCurve> read_blocks(const std::string& text) {
  std::vector<ReadCurve> curves;
  bool title_next = false;
  for (const std::string& line : lines_of(text)) {
    if (line.size() > 100) throw std::runtime_error("longer than 100: " + line);
    if (line.starts_with("#include") || line.starts_with("#enddata") || line.starts_with("#RADIOSS"))
      throw std::runtime_error("no comment: " + line);
    if (line.starts_with("#") || line.starts_with("$")) continue;
    if (line.starts_with("/")) {
      if (!line.starts_with("/FUNCT/")) throw std::runtime_error("another block: " + line);
      curves.emplace_back().id = std::stoi(line.substr(7));
      title_next = true;
    } else if (title_next) {
      curves.back().title = line;
      title_next = false;
    } else {
      read_point(line, curves.at(curves.size() - 1));
    }
  }
  return curves;
}

struct CsvColumns {
  std::string header;
  std::vector<double> x, y;
};

inline CsvColumns read_csv(const std::string& text) {
  CsvColumns columns;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("#")) continue;
    const auto comma = line.find(',');
    if (columns.header.empty()) {
      columns.header = line;
    } else {
      columns.x.push_back(std::stod(line.substr(0, comma)));
      columns.y.push_back(std::stod(line.substr(comma + 1)));
    }
  }
  return columns;
}

}  // namespace dashpad::test
