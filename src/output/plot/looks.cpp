#include "output/plot/looks.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "output/svg/colour_scale.hpp"

namespace dashpad::output {

namespace {

SeriesColour colour_of(const Series& series, std::size_t turn) {
  if (series.shade) return {.class_name = {}, .shade = colour_of_shade(*series.shade)};
  if (is_marker(series.style) && !series.turn) return {.class_name = "dp-grey", .shade = {}};
  return {.class_name = fmt::format("dp-turn-{}", turn % colours_by_turn), .shade = {}};
}

}  // namespace

bool is_marker(SeriesStyle style) {
  return style == SeriesStyle::vertical_line || style == SeriesStyle::horizontal_line;
}

bool is_line(SeriesStyle style) {
  return style == SeriesStyle::line || style == SeriesStyle::solid_line || style == SeriesStyle::dashed_line;
}

bool is_ground(SeriesStyle style) { return style == SeriesStyle::band || style == SeriesStyle::area; }

std::string colour_of_shade(double shade) {
  constexpr std::array<Colour, 9> scale{{{68, 1, 84},
                                         {71, 44, 122},
                                         {59, 81, 139},
                                         {44, 113, 142},
                                         {33, 144, 141},
                                         {39, 173, 129},
                                         {92, 200, 99},
                                         {170, 220, 50},
                                         {253, 231, 37}}};
  return colour_on_scale(scale, shade);
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

Looks looks_of(const Series& series, std::size_t turn) {
  Looks looks{.style = series.style, .colour = colour_of(series, turn)};
  switch (series.style) {
    case SeriesStyle::line:
      // Lines that lie on each other stay visible: the later ones are narrower, and only the first is solid.
      looks.width = std::max(1.5, 2.2 - 0.15 * static_cast<double>(turn));
      looks.pattern = turn % dashes_by_turn;
      break;
    case SeriesStyle::solid_line: looks.width = 2; break;
    case SeriesStyle::dashed_line:
      looks.width = 2;
      looks.pattern = 1;
      break;
    case SeriesStyle::points: looks.pattern = turn % shapes_by_turn; break;
    case SeriesStyle::vertical_line:
    case SeriesStyle::horizontal_line: looks.width = 1.4; break;
    case SeriesStyle::band:
    case SeriesStyle::area: break;
  }
  return looks;
}

Looks looks_of_dot(const Looks& line) {
  return {.style = SeriesStyle::points, .colour = line.colour, .width = 0, .pattern = 0, .is_dot = true};
}

}  // namespace dashpad::output
