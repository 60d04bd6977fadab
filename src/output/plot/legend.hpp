#pragma once
/// Which colours, dashes and shapes the series have, and what the legend says of them.

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

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

/// Behind everything else.
bool is_ground(SeriesStyle style);

/// "#rrggbb" of a shade, between the colours of viridis (Smith, van der Walt 2015): as light as it is high,
/// so that the colour-blind and grey prints tell the order.
std::string colour_of_shade(double shade);

/// "#rrggbb" of a series in that turn.
std::string colour_of(const Series& series, std::size_t turn);

/// gnuplot's words for the looks of a series: "with lines linewidth 2 ...".
std::string looks(const Series& series, std::size_t turn);

/// The same for a dot in place of a line that has only one point.
std::string looks_of_dot(std::size_t turn);

struct LegendEntry {
  std::string label;
  std::string looks;
  bool operator==(const LegendEntry&) const = default;
};

/// Entries in columns as wide as the longest label needs.
struct Legend {
  std::vector<LegendEntry> entries;

  /// Unless the label is empty or the same entry is there already.
  void add(const LegendEntry& entry);
  [[nodiscard]] int columns() const;
  [[nodiscard]] int rows() const;
};

}  // namespace dashpad::output
