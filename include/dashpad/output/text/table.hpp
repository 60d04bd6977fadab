#pragma once
/// A table as people read it: for a terminal, a document or a page.

#include <string>
#include <vector>

namespace dashpad::output {

/// Cells as they are shown. `caption` may be empty.
struct Table {
  std::string caption = {};
  std::vector<std::string> columns = {};
  std::vector<std::vector<std::string>> rows = {};  ///< each with as many cells as there are columns
};

}  // namespace dashpad::output
