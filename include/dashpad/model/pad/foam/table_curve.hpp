#pragma once
/// A base curve given by points of a test: through the origin, monotone cubic between the points.
///
/// Slopes by Fritsch and Butland: the curve rises wherever its points rise, and has a continuous slope.
/// Strain and nominal stress in Pa, compression positive; at least three points, strains increasing and below
/// 1. A base curve rises from point to point; the curve of a higher rate may fall a little.

#include <cstddef>
#include <vector>

namespace dashpad {

struct TableCurve {
  std::vector<double> strain;  ///< (0, 1), increasing
  std::vector<double> stress;  ///< Pa, > 0

  static constexpr const char* name = "table";
  static constexpr std::size_t fewest_points = 3;
  static constexpr std::size_t max_points = 2000;

  friend bool operator==(const TableCurve&, const TableCurve&) = default;
};

}  // namespace dashpad
