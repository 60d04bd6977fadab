#include "output/plot/simplified.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dashpad::output {

namespace {

constexpr double unseen = 0.05;  // px

/// The directions in which a line may go on from a place that stays, so that it passes all places since then
/// close enough. As wedges of Williams (1978).
class Wedge {
 public:
  explicit Wedge(const PlotPlace& tip) : tip_(tip) {}

  /// Whether the line may go to that place; if so, the wedge becomes as narrow as it demands.
  bool takes(const PlotPlace& place) {
    const double x = place.x - tip_.x, y = place.y - tip_.y, distance = std::hypot(x, y);
    if (distance < farthest_) return false;
    if (distance <= unseen) return true;
    if (farthest_ == 0) {
      along_x_ = x / distance;
      along_y_ = y / distance;
    }
    const double angle = std::atan2(along_x_ * y - along_y_ * x, along_x_ * x + along_y_ * y);
    if (angle < low_ || angle > high_) return false;
    const double half_width = std::asin(unseen / distance);
    low_ = std::max(low_, angle - half_width);
    high_ = std::min(high_, angle + half_width);
    farthest_ = distance;
    return true;
  }

 private:
  PlotPlace tip_;
  double along_x_ = 1, along_y_ = 0;
  double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
  double farthest_ = 0;
};

}  // namespace

PlaceLine simplified(const PlaceLine& line) {
  if (line.size() < 3) return line;
  PlaceLine kept{line.front()};
  Wedge wedge{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (wedge.takes(line[i])) continue;
    kept.push_back(line[i - 1]);
    wedge = Wedge{line[i - 1]};
    wedge.takes(line[i]);
  }
  kept.push_back(line.back());
  return kept;
}

}  // namespace dashpad::output
