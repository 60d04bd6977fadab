#pragma once
/// Tables for people who read no page.

#include <string>

#include "dashpad/report/figures_page.hpp"

namespace dashpad {

/// For the document of the validation.
std::string markdown(const PageTable& table);

/// Columns of even width, for a terminal.
std::string plain_text(const PageTable& table);

}  // namespace dashpad
