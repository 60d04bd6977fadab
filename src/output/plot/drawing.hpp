#pragma once
/// The data of a plot that are drawn, and their looks.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/axis_ticks.hpp"

namespace dashpad::output {

/// The numbers of colours, dashes and shapes. The number of colours shares no factor with the others.
inline constexpr std::size_t colours_by_turn = 7, dashes_by_turn = 6, shapes_by_turn = 6;

/// Whether it is a line across the whole panel.
bool is_marker(SeriesStyle style);
/// Whether it goes from point to point.
bool is_line(SeriesStyle style);
/// Whether the style is drawn behind all others.
bool is_ground(SeriesStyle style);

/// The colour of a shade, "#rrggbb", on the viridis scale (Smith, van der Walt 2015). Its lightness rises
/// with the shade, so that it is legible in grey and for the colour-blind.
std::string colour_of_shade(double shade);

/// A class of the style sheet, which knows light and dark paper, or the colour of a shade.
struct SeriesColour {
  std::string class_name = {};  ///< "dp-turn-0"; empty with a shade
  std::string shade = {};       ///< "#rrggbb"; or empty

  bool operator==(const SeriesColour&) const = default;
};

struct Looks {
  SeriesStyle style = SeriesStyle::line;
  SeriesColour colour;
  double width = 0;         ///< px, of lines
  std::size_t pattern = 0;  ///< index of the dashes of a line, or of the shape of points
  bool is_dot = false;      ///< a dot that replaces a line of a single point

  bool operator==(const Looks&) const = default;
};

Looks looks_of(const Series& series, std::size_t palette_index);

/// An entry of the legend.
struct LegendEntry {
  std::string label;
  Looks looks;
  bool operator==(const LegendEntry&) const = default;
};
/// Unless the label is empty or the same entry is there already.
void add_to(std::vector<LegendEntry>& entries, const LegendEntry& entry);

/// A series with what its panel shows of it.
struct SeriesDrawing {
  std::string label = {}, end_label = {};
  std::string of = {};  ///< label of the series to which it belongs
  LabelPlace label_place = LabelPlace::by_style;
  bool is_cased = false;
  bool has_arrow = false;
  Looks looks = {};
  std::vector<PlotRun> runs = {};   ///< thinned; none for vertical and horizontal lines
  std::vector<double> places = {};  ///< places of vertical and horizontal lines
};
LegendEntry entry_of(const SeriesDrawing& series);

struct PanelDrawing {
  std::vector<SeriesDrawing> series;  ///< series with something to show, bands first
  std::vector<LegendEntry> named;     ///< series with a label, in their order
  Span x, y;                          ///< ranges that the axes have to include
  bool has_data = false;              ///< more than vertical and horizontal lines
};

/// The drawings of all panels. Throws std::invalid_argument if no panel has data.
std::vector<PanelDrawing> drawings_of(const Plot& plot);

}  // namespace dashpad::output
