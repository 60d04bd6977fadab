#pragma once
/// Cells of tables by what they hold: numbers stand on the right.

#include <cstddef>
#include <string>

#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// "12.5", "-3e-4", "< 0.1 %", "4.1 ± 0.2"; or what says that there is none: "-", "none".
bool is_number_or_none(const std::string& cell);

/// All cells are, and one at least is a number.
bool is_column_of_numbers(const Table& table, std::size_t column);

}  // namespace dashpad::output
