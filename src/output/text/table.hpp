#pragma once
/// Tables for people who read no page.

#include <string>

#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// As GitHub has them in Markdown.
std::string markdown(const Table& table);

/// For a terminal of 100 columns: where it would be wider the words of its widest columns go on below.
std::string plain_text(const Table& table);

}  // namespace dashpad::output
