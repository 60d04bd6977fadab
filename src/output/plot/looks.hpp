#pragma once
/// Which colours, dashes and shapes series have.

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// Colours, dashes and shapes by turns; later turns begin again. The number of colours shares no
/// factor with the others.
inline constexpr std::size_t colours_by_turn = 7, dashes_by_turn = 6, shapes_by_turn = 6;

/// Hands out the turns that nobody has been given, in the order in which it is asked.
class Turns {
 public:
  explicit Turns(const Plot& plot);
  std::size_t turn_of(const Series& series);

 private:
  std::size_t next();

  std::set<std::size_t> given_;
  std::map<std::string, std::size_t> of_label_;
};

/// Whether it is a line across the whole panel.
bool is_marker(SeriesStyle style);

/// Whether it goes from point to point.
bool is_line(SeriesStyle style);

/// Behind everything else.
bool is_ground(SeriesStyle style);

/// "#rrggbb" of a shade, between the colours of viridis (Smith, van der Walt 2015): as light as it is high,
/// so that the colour-blind and grey prints tell the order.
std::string colour_of_shade(double shade);

/// A class of the style sheet, which knows light and dark paper, or the colour of a shade.
struct SeriesColour {
  std::string class_name;  ///< "dp-turn-0"; empty with a shade
  std::string shade;       ///< "#rrggbb"; or empty

  bool operator==(const SeriesColour&) const = default;
};

struct Looks {
  SeriesStyle style = SeriesStyle::line;
  SeriesColour colour;
  double width = 0;         ///< px, of lines
  std::size_t pattern = 0;  ///< of the dashes of a line by turns, or the shape of points
  bool is_dot = false;      ///< in place of a line that has only one point

  bool operator==(const Looks&) const = default;
};

Looks looks_of(const Series& series, std::size_t turn);

/// The same for a dot in place of a line that has only one point.
Looks looks_of_dot(const Looks& line);

}  // namespace dashpad::output
