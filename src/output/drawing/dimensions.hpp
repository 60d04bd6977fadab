#pragma once
/// Dimension lines with their values, one above the other.

#include <string>
#include <vector>

namespace dashpad::output {

struct Dimension {
  std::string of;     ///< what it is, as the attribute data-of: "penetration"
  double metres = 0;  ///< its value
  double from = 0;    ///< y, px
  double to = 0;
  std::string value;      ///< as it is shown
  std::string word = {};  ///< below it; may be empty
  bool is_cut = false;    ///< drawn shorter than it is
  bool is_alarm = false;  ///< in the colour of what is struck through
};

/// A column of dimensions at x, their labels to the right of it or to the left. Labels keep clear of each
/// other and between the heights `top` and `bottom`.
struct DimensionColumn {
  double x = 0;
  bool labels_left = false;
  double top = 0;
  double bottom = 0;
};
std::string dimension_column(const std::vector<Dimension>& dimensions, const DimensionColumn& column);

/// Places from above to below, each at least its own distance below the one before, within [lowest, highest]
/// as far as they have room there, and otherwise near where they were wanted.
std::vector<double> kept_apart(std::vector<double> wanted, const std::vector<double>& distance, double lowest,
                               double highest);

}  // namespace dashpad::output
