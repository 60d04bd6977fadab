#pragma once
/// What the legend of a plot says.

#include <cstddef>
#include <string>
#include <vector>

#include "output/plot/looks.hpp"

namespace dashpad::output {

struct LegendEntry {
  std::string label;
  Looks looks;
  bool operator==(const LegendEntry&) const = default;
};

/// Unless the label is empty or the same entry is there already.
void add_to(std::vector<LegendEntry>& entries, const LegendEntry& entry);

/// Entries in columns as wide as the longest label needs; a label that has no room in the whole width goes on
/// in further lines. Lengths are in px.
struct Legend {
  static constexpr double row_height = 20;

  std::vector<LegendEntry> entries;

  [[nodiscard]] std::size_t columns(double width) const;
  [[nodiscard]] double height(double width) const;
  /// As SVG, its upper left corner at that place.
  [[nodiscard]] std::string svg(double left, double top, double width) const;
};

}  // namespace dashpad::output
