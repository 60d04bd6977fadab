#pragma once
/// Tables for people who read no page.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// For the document of the validation.
std::string markdown(const Table& table);

/// Columns of even width, for a terminal.
std::string plain_text(const Table& table);

/// Characters of the longest cell of each column; the rows have as many cells as the first.
std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows);

}  // namespace dashpad::output
