#pragma once
/// What there is to draw of a plot.

#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/legend.hpp"
#include "output/plot/rows.hpp"

namespace dashpad::output {

/// A series with what its panel shows of it.
struct SeriesDrawing {
  std::string label, end_label;
  std::string of;  ///< label of the series to which it belongs
  LabelPlace label_place = LabelPlace::by_style;
  bool is_cased = false;
  bool has_arrow = false;
  Looks looks;
  std::vector<PlotRun> runs;   ///< thinned; none for vertical and horizontal lines
  std::vector<double> places;  ///< of vertical and horizontal lines
};

struct PanelDrawing {
  std::vector<SeriesDrawing> series;  ///< those that have something to show, bands first
  std::vector<LegendEntry> named;     ///< those that have a label, in their order
  Span x, y;                          ///< what the axes have to include
  bool has_data = false;              ///< more than vertical and horizontal lines
};

struct PlotDrawing {
  std::vector<PanelDrawing> panels;  ///< as many as the plot has
};

/// What the legend would say of a series.
LegendEntry entry_of(const SeriesDrawing& series);

/// Throws std::invalid_argument if no panel has data.
PlotDrawing drawing_of(const Plot& plot);

}  // namespace dashpad::output
