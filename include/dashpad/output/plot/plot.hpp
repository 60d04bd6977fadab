#pragma once
/// Plots for documents: what to draw as plain values, and the bytes of the picture.

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dashpad::output {

enum class SeriesStyle {
  line,             ///< colour and dashes by palette index, distinguishable in grey, too
  solid_line,       ///< colour by palette index
  dashed_line,      ///< colour by palette index
  points,           ///< colour and shape by palette index
  band,             ///< the area from y to y2, pale, behind everything else
  area,             ///< closed outlines, one after each gap, filled, behind everything else
  vertical_line,    ///< across the whole panel, at each x
  horizontal_line,  ///< across the whole panel, at each y
};

/// The place of the label of a series. Labels without room go to the legend.
enum class LabelPlace {
  by_style,  ///< a line at its end, a line across on it, everything else in the legend
  middle,    ///< a line beside its middle, for brackets and contours; a single point beside it
};

/// A place where x, y or y2 is not finite, or not positive on a logarithmic axis, is a gap.
struct Series {
  std::string label = {};  ///< written in the panel or in the legend; empty: nowhere
  SeriesStyle style = SeriesStyle::line;
  std::vector<double> x = {};   ///< as many as y; unused by horizontal lines
  std::vector<double> y = {};   ///< unused by vertical lines
  std::vector<double> y2 = {};  ///< bands only: as many as y
  /// The index of the colour: 0 is blue, 1 vermilion, and so on. A band, its line and its points should have
  /// the same. By default it is the next free one; series with the same label share it in all panels. Lines
  /// across are grey without it.
  std::optional<std::size_t> palette_index = {};
  /// A place on a scale of colours from 0 (dark blue) to 1 (yellow), instead of the colour of the turn.
  std::optional<double> shade = {};
  /// A label beside the end of the line, right of the panel, instead of `label`. Such labels make room.
  std::string end_label = {};
  LabelPlace label_place = LabelPlace::by_style;
  bool is_cased = false;   ///< a line with pale edges, visible on areas of any colour
  bool has_arrow = false;  ///< a line with an arrow on its last third, in the direction of its points
  std::string of = {};     ///< without a label: the label of the series with which pages switch it off

  void add(double across, double up) {
    x.push_back(across);
    y.push_back(up);
  }
  /// Parts what is added from what is there, if anything is.
  void add_gap() {
    if (!x.empty()) add(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());
  }
};

struct Axis {
  std::string label = {};    ///< label with the unit: "Force (kN)"
  std::string si_unit = {};  ///< the SI unit of the quantity, for pages that change units: "N"; may be empty
  double per_si = 1;         ///< one SI unit on this axis: 0.001
  bool logarithmic = false;
  bool has_numbers = true;          ///< and lines across at them; without, places on it mean nothing
  std::optional<double> low = {};   ///< lower end; by default at or before the beginning of the data
  std::optional<double> high = {};  ///< upper end; by default at or after the end of the data
};

/// A pair of axes. Bands and areas are drawn first; series without a point are left out.
struct Panel {
  std::string title = {};
  Axis x = {};
  Axis y = {};
  std::vector<Series> series = {};

  void add(Series one) { series.push_back(std::move(one)); }
  void add(std::vector<Series> more) {
    for (Series& one : more) series.push_back(std::move(one));
  }
};

/// Panels one below the other, with one legend for what they do not name themselves: a few short labels stand
/// at the ends of lines, and lines across have their names on them. Texts are shown literally. Control
/// characters become spaces, invalid UTF-8 the replacement character. Long texts are cut, but title and
/// source continue on further lines.
struct Plot {
  std::string title = {};
  std::vector<Panel> panels = {};
  std::string source = {};  ///< small print at the bottom: the version, the case
};

/// A plot in a document or on a page.
struct CaptionedPlot {
  std::string name = {};  ///< "Figure 3-4"; may be empty
  Plot plot;
  std::string note = {};  ///< a sentence or two below it
};

enum class PictureFormat { svg, png, pdf };

/// The format by the extension of a file name, in either case. None for other extensions.
std::optional<PictureFormat> picture_format(const std::filesystem::path& file);

/// The bytes of the picture file. The same plot always gives the same SVG, and the same PNG and PDF with the
/// same fonts and libraries. Throws std::invalid_argument if there is nothing to draw or columns or limits do
/// not fit together, and std::runtime_error if a PNG or PDF cannot be made.
std::string picture(const Plot& plot, PictureFormat format);

}  // namespace dashpad::output
