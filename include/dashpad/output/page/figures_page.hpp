#pragma once
/// The answer, figures, tables and text as a page to look at in a browser: one HTML file, which asks nothing
/// of any network. The figures are the same values that picture() draws as stills. All there is to see is
/// there without a script; the page's own makes the figures answer to a pointer.

#include <optional>
#include <string>
#include <utility>
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

/// What an answer or a figure means to whoever decides by it: never shown by its colour alone.
enum class Tone { plain, good, doubtful, bad };

/// A figure that matters, large, and where it has a limit as a bar towards it.
struct KeyFigure {
  std::string label = {};
  std::string value = {};            ///< with its unit
  std::string limit = {};            ///< in words, "at most 80 g"; empty: it has none
  std::optional<double> share = {};  ///< value over limit, >= 0: a bar
  /// The ends of its interval over the limit: drawn over the bar; the second may be infinite.
  std::optional<std::pair<double, double>> share_range = {};
  Tone tone = Tone::plain;
};

/// What a person came to decide, on top of all else.
struct Lead {
  std::string answer = {};  ///< one sentence: the heading of the page
  Tone tone = Tone::plain;
  std::string reservation = {};           ///< the strongest, and how many more there are; may be empty
  std::vector<std::string> subject = {};  ///< what was asked, a line each
  std::string drawing = {};               ///< an SVG that this library has made; may be empty
  std::optional<Plot> curve = {};         ///< the one that decides
  std::vector<KeyFigure> figures = {};    ///< up to six
};

/// Shown in this order: heading, text, bars, tables, figures, text to copy.
struct PageSection {
  std::string heading = {};
  std::vector<std::string> paragraphs = {};
  std::vector<RangeBar> ranges = {};
  std::vector<Table> tables = {};
  std::vector<CaptionedPlot> figures = {};
  std::string copy = {};  ///< text in lines of its own, to be copied, such as a case file
};

struct FiguresPage {
  std::string title = {};
  std::optional<Lead> lead = {};           ///< in place of the title as the heading
  std::vector<std::string> summary = {};   ///< paragraphs below the title
  std::vector<std::string> warnings = {};  ///< their first words, in capitals, are set apart
  std::vector<PageSection> sections = {};
  bool is_one_impact = false;  ///< all plots over time show the same moment to whoever points at one
};

/// The HTML file. Each panel of each plot is interactive: the values under the cursor, zoom by dragging, and
/// series switched off and on. Throws std::invalid_argument for rows or columns that do not fit together, and
/// for bars that are not between 0 and 1.
std::string figures_page(const FiguresPage& page);

}  // namespace dashpad::output
