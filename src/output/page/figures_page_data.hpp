#pragma once
/// What the page of figures shows, as JSON.

#include <string>

#include "dashpad/output/page/figures_page.hpp"

namespace dashpad::output {

/// JSON in one line without a "<", so that no text of a user ends the element that holds it, or begins
/// another. Columns have seven digits and are thinned to what a plot can show, even enlarged. The page has
/// passed check().
std::string figures_page_data(const FiguresPage& page);

}  // namespace dashpad::output
