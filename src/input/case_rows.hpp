#pragma once
/// Tables of cases: a row a case, a column a number of the case by its key.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// A key that a column may have.
struct RowKey {
  std::string key;            ///< key in case files: "impactor.speed"
  std::string unit;           ///< SI; "1" for a pure number, "" for a text such as the name of a material
  bool may_be_empty = false;  ///< a cell then has no value (NaN), or no text
  bool is_whole = false;      ///< nothing but a unit may follow it in a header: "drop date" is no drop
};

/// A column of a table of cases.
struct RowColumn {
  std::string key;                 ///< key, or the header of a label
  std::string unit;                ///< SI; "" for texts
  std::vector<double> values;      ///< SI; empty for texts
  std::vector<std::string> texts;  ///< empty for numbers
};

struct CaseRows {
  std::vector<RowColumn> columns;  ///< those of keys, in the order of the file
  std::vector<RowColumn> labels;   ///< other columns, kept as texts
  int header_line = 0;
  std::vector<int> lines;  ///< line of each row in the file
};

inline constexpr std::size_t max_case_rows = 100'000;

/// Reads a CSV file of cases. The first row has the headers: a key, followed by its unit in brackets or after
/// an underscore ("impactor.speed [mph]", "impactor.speed_m_per_s"), unless each cell has its unit ("20
/// mph"). Commas, semicolons or tabs separate; # begins a comment. A header that does not begin with the name
/// of a table of cases is a label. Faults, each with its line and header: a key that is repeated or unknown
/// (worded by `unknown`), a cell that is empty, not a number, or in an unsuitable unit. In an acceleration, g
/// is standard gravity.
Reading<CaseRows> read_case_rows(const std::filesystem::path& file, std::span<const RowKey> keys,
                                 const std::function<std::string(const std::string& key)>& unknown);

}  // namespace dashpad::input
