#pragma once
/// Tables for people who read no page.

#include <string>

#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// The table in GitHub's Markdown.
std::string markdown(const Table& table);

/// The table for a terminal of 100 columns; the texts of its widest columns continue on further lines if
/// necessary.
std::string plain_text(const Table& table);

}  // namespace dashpad::output
