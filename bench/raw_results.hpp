#pragma once
/// Raw results as the programs of this folder write them: facts in lines "# key: value", then a table of
/// comma-separated cells without quotes.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dashpad::bench {

class RawResults {
 public:
  /// Throws std::runtime_error for a file that it cannot read.
  explicit RawResults(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& facts() const { return facts_; }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const;
  [[nodiscard]] double number(std::size_t row, const std::string& column) const;
  /// The values of a column, each once, in the order in which they come.
  [[nodiscard]] std::vector<std::string> values(const std::string& column) const;

 private:
  std::vector<std::pair<std::string, std::string>> facts_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace dashpad::bench
