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
  line,             ///< in the colour and with the dashes of its turn: told apart in grey, too
  solid_line,       ///< in the colour of its turn
  dashed_line,      ///< in the colour of its turn
  points,           ///< in the colour and shape of its turn
  band,             ///< the area from y to y2, pale, behind everything else
  area,             ///< closed outlines, one after each gap, filled, behind everything else
  vertical_line,    ///< across the whole panel, at each x
  horizontal_line,  ///< across the whole panel, at each y
};

/// Where the label of a series is written. What has no room there goes to the legend.
enum class LabelPlace {
  by_style,  ///< of a line at its end, of a line across on it, of everything else in the legend
  middle,    ///< of a line: beside its middle, for brackets and contours; of a single point: beside it
};

/// A place where x, y or y2 is not finite, or not positive on a logarithmic axis, is a gap.
struct Series {
  std::string label = {};  ///< written in the panel or in the legend; empty: nowhere
  SeriesStyle style = SeriesStyle::line;
  std::vector<double> x = {};   ///< as many as y; unused by horizontal lines
  std::vector<double> y = {};   ///< unused by vertical lines
  std::vector<double> y2 = {};  ///< bands only: as many as y
  /// Turn 0 is blue, 1 vermilion, and so on. Give a band, its line and its points the same. By default the
  /// next one that is free; the same label has the same turn in all panels. Vertical and horizontal lines are
  /// grey without it.
  std::optional<std::size_t> palette_index = {};
  /// A place on a scale of colours from 0 (dark blue) to 1 (yellow), instead of the colour of the turn.
  std::optional<double> shade = {};
  /// Written to the right of the panel in place of the label, beside where the line ends, however many such
  /// labels there are; they make room for each other.
  std::string end_label = {};
  LabelPlace label_place = LabelPlace::by_style;
  bool is_cased = false;   ///< of a line: with pale edges, so that it is seen on areas of any colour
  bool has_arrow = false;  ///< of a line: on its last third, in the direction in which its points follow
  std::string of = {};     ///< without a label: that of the series with which pages switch it off

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
  std::string label = {};    ///< with the unit: "Force (kN)"
  std::string si_unit = {};  ///< the SI unit of the quantity, for pages that change units: "N"; may be empty
  double per_si = 1;         ///< what one of those is on this axis: 0.001
  bool logarithmic = false;
  bool has_numbers = true;          ///< and lines across at them; without, places on it mean nothing
  std::optional<double> low = {};   ///< where the axis begins; by default where the data does, or before
  std::optional<double> high = {};  ///< where the axis ends; by default where the data does, or after
};

/// One pair of axes. The series are drawn in their order, bands and areas first; those without a point are
/// left out.
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

/// Panels one below the other, with one legend below the last for what the panels do not name: lines have
/// their labels at their ends where these are few and short, lines across on themselves. Texts are shown as
/// they are, character by character; control characters become spaces, what is not UTF-8 the replacement
/// character, and what is too long is cut, but for title and source, which go on in the next line.
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

/// By the ending of a file's name, in small or capital letters. None for other endings.
std::optional<PictureFormat> picture_format(const std::filesystem::path& file);

/// The bytes of the picture file. The same plot gives the same SVG everywhere, and the same PNG and PDF where
/// fonts and libraries are the same. Throws std::invalid_argument if there is nothing to draw, or if columns
/// or limits do not fit together; std::runtime_error if a PNG or PDF cannot be made.
std::string picture(const Plot& plot, PictureFormat format);

}  // namespace dashpad::output
