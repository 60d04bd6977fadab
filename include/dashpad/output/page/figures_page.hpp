#pragma once
/// Figures, tables and text as a page to look at in a browser: one HTML file, which asks nothing of any
/// network. The figures are the same values that picture() draws as stills.

#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// A value with its interval on the way from one bound to another, as a bar.
struct RangeBar {
  std::string label = {};
  std::string value = {};   ///< as it is shown, with its unit
  std::string words = {};   ///< the interval
  std::string lowest = {};  ///< the bounds
  std::string highest = {};
  double place = 0;                             ///< of the value: 0 at the lowest, 1 at the highest
  double from = 0, to = 1;                      ///< of the interval
  bool open_below = false, open_above = false;  ///< it has no end there
};

/// Shown in this order: heading, text, bars, tables, figures.
struct PageSection {
  std::string heading = {};
  std::vector<std::string> paragraphs = {};
  std::vector<RangeBar> ranges = {};
  std::vector<Table> tables = {};
  std::vector<CaptionedPlot> figures = {};
};

struct FiguresPage {
  std::string title = {};
  std::vector<std::string> summary = {};   ///< paragraphs below the title
  std::vector<std::string> warnings = {};  ///< their first words, in capitals, are set apart
  std::vector<PageSection> sections = {};
};

/// The HTML file. Each panel of each plot is interactive: the values under the cursor, zoom by dragging, and
/// series switched off and on in the legend; curves that go forth and back (loops) are drawn as given. Throws
/// std::runtime_error with the text of no_page (dashpad/output/page/page.hpp) where has_page() is false, and
/// std::invalid_argument for rows or columns that do not fit together, and for bars
/// that are not between 0 and 1.
std::string figures_page(const FiguresPage& page);

}  // namespace dashpad::output
