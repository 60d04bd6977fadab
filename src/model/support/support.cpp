#include "dashpad/model/support/support.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace dashpad {
namespace {

/// Relative change of slope below which it comes from rounding of the points.
constexpr double slope_rounding = 1e-12;

bool increases(const Support::Point& from, const Support::Point& to) {
  return std::isfinite(to.deflection) && std::isfinite(to.force) && to.deflection > from.deflection &&
         to.force > from.force;
}

}  // namespace

Support Support::linear(double stiffness) {
  if (!(std::isfinite(stiffness) && stiffness > 0))
    throw std::invalid_argument("the stiffness of a support must be finite and more than 0");
  return through({{1, stiffness}});
}

Support Support::through(std::vector<Point> points) {
  if (points.empty()) throw std::invalid_argument("the curve of a support needs at least one point");
  Support support;
  Point from;
  double energy = 0;
  for (const Point& to : points) {
    if (!increases(from, to))
      throw std::invalid_argument(
          "the points of a support must be finite and strictly increasing from the origin");
    const double stiffness = (to.force - from.force) / (to.deflection - from.deflection);
    if (!support.stiffness_.empty() &&
        std::abs(stiffness - support.stiffness_.back()) > slope_rounding * support.stiffness_.back())
      support.corners_.push_back(from.force);
    support.stiffness_.push_back(stiffness);
    support.energy_.push_back(energy);
    energy += 0.5 * (from.force + to.force) * (to.deflection - from.deflection);
    from = to;
  }
  support.points_ = std::move(points);
  return support;
}

/// Index of the segment that contains a force: the upper one at a point, the last one beyond the points.
std::size_t Support::segment_of_force(double force) const {
  const auto last = points_.end() - 1;
  return static_cast<std::size_t>(std::ranges::upper_bound(points_.begin(), last, force, {}, &Point::force) -
                                  points_.begin());
}

double Support::force(double deflection) const {
  if (deflection <= 0) return 0;
  const auto last = points_.end() - 1;
  const auto upper = std::ranges::upper_bound(points_.begin(), last, deflection, {}, &Point::deflection);
  const auto segment = static_cast<std::size_t>(upper - points_.begin());
  const Point lower = segment > 0 ? points_[segment - 1] : Point{};
  const double force = lower.force + stiffness_[segment] * (deflection - lower.deflection);
  // Rounding must not lift the end of a segment above the start of the next.
  return upper == last ? force : std::min(force, upper->force);
}

double Support::deflection(double force) const {
  if (is_rigid() || force <= 0) return 0;
  const std::size_t segment = segment_of_force(force);
  const Point lower = segment > 0 ? points_[segment - 1] : Point{};
  const double deflection = lower.deflection + (force - lower.force) / stiffness_[segment];
  return segment + 1 == points_.size() ? deflection : std::min(deflection, points_[segment].deflection);
}

double Support::compliance(double force) const {
  return is_rigid() ? 0 : 1 / stiffness_[segment_of_force(force)];
}

double Support::energy(double force) const {
  if (is_rigid() || force <= 0) return 0;
  const std::size_t segment = segment_of_force(force);
  const double lower = segment > 0 ? points_[segment - 1].force : 0;
  return energy_[segment] + 0.5 * (force + lower) * (force - lower) / stiffness_[segment];
}

double Support::balanced(double slope, double force) const {
  if (force <= 0) return force / slope;
  const auto upper = std::partition_point(points_.begin(), points_.end() - 1, [&](const Point& point) {
    return point.force + slope * point.deflection <= force;
  });
  const auto segment = static_cast<std::size_t>(upper - points_.begin());
  const Point lower = segment > 0 ? points_[segment - 1] : Point{};
  return lower.deflection + (force - lower.force - slope * lower.deflection) / (stiffness_[segment] + slope);
}

}  // namespace dashpad
