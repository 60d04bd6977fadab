#pragma once
/// Documents: the result of a subject such as an impact, a pulse or a study, with values and texts in the
/// reader's units. Writers lay them out for the terminal, as web pages and as Markdown.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// The amount of detail.
enum class Detail {
  main,  ///< the main figures to four digits, errors in one line or, where they are large, beside the figure
  all,   ///< every figure to five digits, each with its error
};
/// Significant digits of figures.
constexpr int digits_of(Detail detail) { return detail == Detail::all ? 5 : 4; }

/// A value with its interval on the way from one bound to another, as a bar.
struct RangeBar {
  std::string label = {};
  std::string value = {};   ///< the value as it is shown, with its unit
  std::string words = {};   ///< the interval
  std::string lowest = {};  ///< the bounds
  std::string highest = {};
  double place = 0;                             ///< place of the value: 0 at the lowest, 1 at the highest
  double from = 0, to = 1;                      ///< ends of the interval
  bool open_below = false, open_above = false;  ///< it has no end there
};

/// The meaning of an answer or a figure for a decision. It is never shown by colour alone.
enum class Tone { plain, good, doubtful, bad };

/// A figure as people read it, with what goes with it; what is empty is not shown.
struct ValueRow {
  std::string key = {};  ///< key in the table of results, if it has one
  std::string label = {};
  std::string value = {};
  std::string unit = {};             ///< empty too where the value has it
  std::optional<double> error = {};  ///< estimated, relative; may be infinite
  std::string interval = {};         ///< "34.1 to 38.2 g", by what is not known
  std::string limit = {};            ///< "at most 80 g"
  std::string remark = {};
  std::optional<double> share = {};  ///< value over limit, >= 0: a bar
  /// The ends of its interval over the limit: drawn over the bar; the second may be infinite.
  std::optional<std::pair<double, double>> share_range = {};
  Tone tone = Tone::plain;
};

/// The answer on top of a document.
struct Lead {
  std::string answer = {};  ///< one sentence: the heading of the page
  Tone tone = Tone::plain;
  std::vector<std::string> subject = {};  ///< the question or its circumstances, a line each
  std::string drawing = {};               ///< an SVG that this library has made; may be empty
  std::optional<Plot> curve = {};         ///< the one that decides
  /// The most important first: a page shows six large, the terminal all of them in short.
  std::vector<ValueRow> figures = {};
};

/// The outputs in which a section is shown.
enum class Seen {
  always,
  in_brief,  ///< only on a terminal without --all
  in_full,   ///< with --all, on pages and in Markdown
  on_pages,  ///< on pages and in Markdown
};

/// Figures that belong together, below a line of their own if there is one.
struct RowGroup {
  std::string caption = {};
  std::vector<ValueRow> rows = {};
  const char* error = "Numerical error";  ///< what the errors of the rows are
};

/// Shown in this order: heading, figures by rows, text, bars, tables, plots, text to copy.
struct Section {
  std::string heading = {};
  Seen seen = Seen::in_full;
  std::vector<RowGroup> rows = {};
  std::vector<std::string> paragraphs = {};
  std::vector<RangeBar> ranges = {};
  std::vector<Table> tables = {};
  std::vector<CaptionedPlot> figures = {};
  std::string copy = {};  ///< text in lines of its own, to be copied, such as a case file
};

struct Document {
  std::string title = {};
  std::optional<Lead> lead = {};          ///< replaces the title as the heading
  std::vector<std::string> summary = {};  ///< paragraphs below the title
  /// Warnings, the most serious first; the words in capitals at their front are set apart.
  std::vector<std::string> warnings = {};
  std::vector<Section> sections = {};
  bool is_one_impact = false;  ///< all plots over time show the same moment to whoever points at one
};

/// Whether a document is made with its drawing and its plots, which take longer than all the rest; of its
/// lead alone, for a page that follows a slider.
enum class Pictures { left_out, of_lead, drawn };

/// The document as one HTML file without external references. It is complete without its script, which makes
/// the plots interactive; they show the same values as picture(). Throws std::invalid_argument for rows or
/// columns that do not fit together, and for bars not between 0 and 1.
///
/// Example:
/// \code
/// dashpad::output::Document document{.title = "Three pads"};
/// document.sections = {{.heading = "Peaks", .paragraphs = {"30 mm: 96 g", "40 mm: 71 g", "50 mm: 58 g"}}};
/// std::ofstream("pads.html") << dashpad::output::to_html(document);
/// std::puts(dashpad::output::to_terminal(document, dashpad::output::Detail::all).c_str());
/// \endcode
std::string to_html(const Document& document);

/// The document as plain text of at most 100 columns: answer, subject, warnings, figures, then the sections
/// shown with that detail. Plots and bars are left out.
std::string to_terminal(const Document& document, Detail detail);

/// The document as Markdown, without plots and drawings.
std::string to_markdown(const Document& document);

}  // namespace dashpad::output
