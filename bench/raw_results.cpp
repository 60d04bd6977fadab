#include "raw_results.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace dashpad::bench {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

RawResults::RawResults(const std::filesystem::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("# ")) {
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos) facts_.emplace_back(line.substr(2, colon - 2), line.substr(colon + 2));
    } else if (columns_.empty()) {
      columns_ = cells_of(line);
    } else {
      rows_.push_back(cells_of(line));
      if (rows_.back().size() != columns_.size())
        throw std::runtime_error(file.string() + ": a line has too few or too many cells: " + line);
    }
  }
  if (rows_.empty()) throw std::runtime_error("no results in " + file.string());
}

const std::string& RawResults::text(std::size_t row, const std::string& column) const {
  const auto place = std::find(columns_.begin(), columns_.end(), column);
  if (place == columns_.end()) throw std::runtime_error("raw results without a column " + column);
  return rows_[row][static_cast<std::size_t>(place - columns_.begin())];
}

double RawResults::number(std::size_t row, const std::string& column) const {
  return std::stod(text(row, column));
}

std::vector<std::string> RawResults::values(const std::string& column) const {
  std::vector<std::string> all;
  for (std::size_t row = 0; row < size(); ++row)
    if (const std::string& value = text(row, column); std::find(all.begin(), all.end(), value) == all.end())
      all.push_back(value);
  return all;
}

}  // namespace dashpad::bench
