#pragma once
/// The one renderer of plots, for pages, stills and documents, and its style sheet.

#include <string>
#include <string_view>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// Sizes of the texts of a plot, px. A plot as wide as a phone is shown somewhat smaller than it is laid out;
/// pages with more room set smaller texts.
inline constexpr double title_text = 18, panel_title_text = 16, axis_text = 15.2,
                        label_text = 14.8,  ///< of names beside what they name, and of numbers
    source_text = 12.5;
/// px.
inline constexpr double usual_plot_width = 900;

/// Whoever puts many plots on one page has the sheet there once.
enum class PlotStyle { none, light, light_and_dark };

/// It does not depend on the plot.
std::string_view style_sheet(PlotStyle style);

/// One SVG without script, identifiers and anything from elsewhere, so that several can stand in one page.
/// The same plot gives the same bytes everywhere. The plot has been checked. Throws std::invalid_argument if
/// nothing in it can be drawn.
///
/// For scripts, all that is drawn of a panel is `g.dp-panel`: data-x-low, -x-high, -x-log (0 or 1), -x-label,
/// -x-numbers (0) where it has none, -x-most of them that have room, where it has an SI unit -x-unit and
/// -x-per-si, and the same of y; data-width and -height of its axes in px. In it, `svg.dp-inside` begins
/// where the axes do, and holds a `g.dp-series` for each series, with data-label and data-style, and one path
/// in px; a pale edge of a line is another, with its label. What belongs to a series, as its arrow or band,
/// has that label as data-of. Names in the panel are `g.dp-mark` in `g.dp-marks`, and `g.dp-end` in
/// `g.dp-ends`, each with the data-label of its series; what they name is not among the `g.dp-entry` of the
/// legend. `width` in px: texts keep their size, so that a narrow plot can be read where there is little
/// room.
std::string svg_plot(const Plot& plot, PlotStyle style, double width = usual_plot_width);

}  // namespace dashpad::output
