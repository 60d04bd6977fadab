#include "output/plot/legend.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "output/plot/text.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Okabe and Ito's colours, which the colour-blind tell apart, but for yellow, which is too pale on white.
constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
/// Lengths of dashes and gaps. As many as share no factor with the number of colours.
constexpr std::array dashes{"solid", "(10,4)", "(3,3)", "(10,4,2,4)", "(16,4,2,4,2,4)", "(6,4,2,2)"};
/// Disc, square, triangle, diamond, triangle on its tip, and ring.
constexpr std::array shapes{7, 5, 9, 13, 11, 6};

constexpr auto marker_colour = "#555555";

std::string line(const std::string& colour, double width, const char* dash) {
  return fmt::format("with lines linewidth {} linecolor rgb '{}' dashtype {}", width, colour, dash);
}

}  // namespace

bool is_marker(SeriesStyle style) {
  return style == SeriesStyle::vertical_line || style == SeriesStyle::horizontal_line;
}

bool is_ground(SeriesStyle style) { return style == SeriesStyle::band || style == SeriesStyle::area; }

std::string colour_of_shade(double shade) {
  using Colour = std::array<double, 3>;
  constexpr std::array<Colour, 9> scale{{{68, 1, 84},
                                         {71, 44, 122},
                                         {59, 81, 139},
                                         {44, 113, 142},
                                         {33, 144, 141},
                                         {39, 173, 129},
                                         {92, 200, 99},
                                         {170, 220, 50},
                                         {253, 231, 37}}};
  const double place = std::clamp(shade, 0.0, 1.0) * (scale.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double part = place - static_cast<double>(below);
  const auto mixed = [&](std::size_t i) {
    return static_cast<int>(std::lround(std::lerp(scale[below][i], scale[below + 1][i], part)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

Turns::Turns(const Plot& plot) {
  for (const Panel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      if (series.turn) given_.insert(*series.turn);
    }
  }
}

std::size_t Turns::turn_of(const Series& series) {
  if (series.turn) return *series.turn;
  if (is_marker(series.style)) return 0;
  if (series.label.empty()) return next();
  const auto known = of_label_.find(series.label);
  return known != of_label_.end() ? known->second : of_label_[series.label] = next();
}

std::size_t Turns::next() {
  std::size_t turn = 0;
  while (!given_.insert(turn).second) ++turn;
  return turn;
}

std::string colour_of(const Series& series, std::size_t turn) {
  return series.shade ? colour_of_shade(*series.shade) : colours[turn % colours.size()];
}

std::string looks(const Series& series, std::size_t turn) {
  // Lines that lie on each other stay visible: the later ones are narrower, and only the first is solid.
  const double width = std::max(1.6, 2.8 - 0.24 * static_cast<double>(turn));
  const std::string colour = colour_of(series, turn);
  switch (series.style) {
    case SeriesStyle::line: return line(colour, width, dashes[turn % dashes.size()]);
    case SeriesStyle::solid_line: return line(colour, 2.2, "solid");
    case SeriesStyle::dashed_line: return line(colour, 2.2, dashes[1]);
    case SeriesStyle::points:
      return fmt::format("with points pointtype {} pointsize 0.8 linewidth 1.2 linecolor rgb '{}'",
                         shapes[turn % shapes.size()], colour);
    case SeriesStyle::band:
      return fmt::format("with filledcurves fillstyle transparent solid 0.22 noborder fillcolor rgb '{}'",
                         colour);
    // The border closes the seams between outlines.
    case SeriesStyle::area:
      return fmt::format(
          "with filledcurves closed fillcolor rgb '{0}' fillstyle solid 1 border linecolor rgb '{0}'",
          colour);
    case SeriesStyle::vertical_line:
    case SeriesStyle::horizontal_line: return line(series.turn ? colour : marker_colour, 1.4, "(5,3)");
  }
  return {};
}

std::string looks_of_dot(std::size_t turn) {
  return fmt::format("with points pointtype 7 pointsize 0.4 linecolor rgb '{}'",
                     colours[turn % colours.size()]);
}

void Legend::add(const LegendEntry& entry) {
  if (entry.label.empty() || std::ranges::find(entries, entry) != entries.end()) return;
  entries.push_back(entry);
}

int Legend::columns() const {
  constexpr double room = 790, width_of_sample = 70, width_of_character = 8.2;  // pixels; a wide font
  std::size_t longest = 1;
  for (const LegendEntry& entry : entries) longest = std::max(longest, width_of(entry.label));
  const double width = width_of_sample + width_of_character * static_cast<double>(longest);
  return std::max(1, static_cast<int>(room / width));
}

int Legend::rows() const { return (static_cast<int>(entries.size()) + columns() - 1) / columns(); }

}  // namespace dashpad::output
