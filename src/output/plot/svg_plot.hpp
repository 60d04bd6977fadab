#pragma once
/// The one renderer of plots, for pages, stills and documents, and its style sheet.

#include <string>
#include <string_view>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// Sizes of the texts of a plot, px. Phones show plots smaller; pages with more room set smaller texts.
inline constexpr double title_text = 18, panel_title_text = 16, axis_text = 15.2,
                        label_text = 14.8,  ///< names beside what they name, and numbers
    source_text = 12.5;
/// px.
inline constexpr double usual_plot_width = 900;

/// Which style sheet a plot contains. Pages with many plots contain it once instead.
enum class PlotStyle { none, light, light_and_dark };

/// The style sheet, the same for all plots.
std::string_view style_sheet(PlotStyle style);

/// The plot as one SVG without scripts, ids and references, so that several can stand in one page. The same
/// plot always gives the same bytes. The plot must have passed check(). Throws std::invalid_argument if
/// nothing in it can be drawn.
///
/// For scripts, each panel is a `g.dp-panel` with the attributes data-x-low, -x-high, -x-log (0 or 1),
/// -x-label, -x-numbers (0 if it has none), -x-most (labels that have room) and, if the SI unit is known,
/// -x-unit and -x-per-si, the same for y, and data-width and -height of the axes in px. Its `svg.dp-inside`
/// has its origin at the axes and contains a `g.dp-series` for each series, with data-label, data-style and
/// one path in px; the pale edge of a line is a series of its own with the same label. Arrows and bands refer
/// to the label of their series by data-of. Names in the panel are `g.dp-mark` in `g.dp-marks` and `g.dp-end`
/// in `g.dp-ends`, with the data-label of their series; what they name has no `g.dp-entry` in the legend.
/// `width` is in px; texts keep their size, so that narrow plots stay readable.
std::string svg_plot(const Plot& plot, PlotStyle style, double width = usual_plot_width);

}  // namespace dashpad::output
