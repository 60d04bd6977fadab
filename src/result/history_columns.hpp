#pragma once
/// The columns of a history by the quantities of the table of results, but for the strains of layers.

#include <span>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad {

struct HistoryColumn {
  const char* key;  ///< in the table of results
  std::vector<double> History::*values;
  bool is_optional = false;  ///< empty for impacts that do not have it
};

/// All of them, in the order of files.
std::span<const HistoryColumn> history_columns();

}  // namespace dashpad
