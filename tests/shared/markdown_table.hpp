#pragma once
/// Tables in Markdown, read back and compared.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace dashpad::test {

/// Rows of trimmed cells without escapes, and without the line below the header.
inline std::vector<std::vector<std::string>> read_markdown(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|") || line.starts_with("|---")) continue;
    std::vector<std::string> cells(1);
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i] == '\\' && i + 1 < line.size() &&
          std::ispunct(static_cast<unsigned char>(line[i + 1])) != 0)
        cells.back() += line[++i];
      else if (line[i] == '|')
        cells.emplace_back();
      else
        cells.back() += line[i];
    }
    cells.pop_back();
    for (std::string& cell : cells) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
    }
    rows.push_back(std::move(cells));
  }
  return rows;
}

/// Words the same, numbers within one unit of the last digit of the coarser of the two, or within a share of
/// themselves.
inline bool same_cell(const std::string& a, const std::string& b, double share = 0) {
  static const std::regex number(R"([+-]?\d+(\.(\d+))?(e[+-]?\d+)?)");
  if (std::regex_replace(a, number, "#") != std::regex_replace(b, number, "#")) return false;
  const auto unit = [](const std::smatch& match) {
    const double power = match[3].matched ? std::atof(match[3].str().c_str() + 1) : 0;
    return std::pow(10, power - static_cast<double>(match[2].length()));
  };
  std::sregex_iterator in_a(a.begin(), a.end(), number), in_b(b.begin(), b.end(), number);
  for (; in_a != std::sregex_iterator{}; ++in_a, ++in_b) {
    const double x = std::atof(in_a->str().c_str()), y = std::atof(in_b->str().c_str());
    if (std::abs(x - y) > 1.000001 * std::max({unit(*in_a), unit(*in_b), share * std::abs(y)})) return false;
  }
  return true;
}

}  // namespace dashpad::test
