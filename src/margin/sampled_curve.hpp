#pragma once
/// A curve of which a few points are known.

#include <vector>

namespace dashpad::margin {

struct Point {
  double place;
  double height;  ///< finite, or infinite where the curve is beyond all limits
};

/// The height between points in order of their places: both parabolas through the two neighbours and a third
/// point, each weighed by its nearness, and never beyond the heights of the two neighbours. Next to an
/// infinite height nothing tells how far: that of the nearer point. Beyond the ends the height there.
///
/// \param points at least one
double height_at(const std::vector<Point>& points, double place);

}  // namespace dashpad::margin
