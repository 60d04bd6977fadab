#pragma once
/// Depths of the columns of a contact, from the axis outwards and denser towards the axis, which is touched
/// first and has the steepest stress when the gap closes (theory.md, section 3, Stations).
///
/// Lengths in m.

#include <algorithm>
#include <cstddef>

#include "dashpad/model/nose/sections.hpp"

namespace dashpad {

/// Spacing of the stations, in the resolution rho of a run (theory.md, section 4). None of these is physics:
/// with finer resolution the integral converges to the same value for any of them.
struct StationSpacing {
  double even = 0.8;    ///< share of the expected contact between two stations
  double first = 0.2;   ///< share of that from the axis to the first station (no rho)
  double of_gap = 8;    ///< share of the gap at a station: the stress at the axis varies over it
  double of_depth = 3;  ///< share of the depth of a station: those near the axis are touched first
  double graded = 4;    ///< depth within which stations are added as the gap closes, in gaps (no rho)
};
inline constexpr StationSpacing station_spacing;

/// Largest number of stations. A run that needs more is incomplete and is not used.
inline constexpr std::size_t max_stations = 20'000;

/// Requirements on the stations, m.
struct StationPlan {
  double resolution = 0;
  double expected = 0;  ///< expected largest penetration
  double reach = 0;     ///< depth up to which columns are laid
  double gap = 0;       ///< gap between nose and support on the axis
  StationSpacing spacing = station_spacing;
};

/// The knots of a shape in order; columns are laid there since a' jumps.
class KnotsAhead {
 public:
  explicit KnotsAhead(const Sections& nose) {
    if (!nose.shape) return;
    next_ = nose.shape->knots().data();
    end_ = next_ + nose.shape->knots().size();
  }
  /// The next knot if it lies before `depth` or less than 0.3 `step` beyond; else `depth`.
  double stop(double depth, double step) {
    if (next_ == end_ || *next_ > depth + 0.3 * step) return depth;
    return *next_++;
  }

 private:
  const double* next_ = nullptr;
  const double* end_ = nullptr;
};

/// Calls append(depth) for each station, at most max_stations times: evenly over the expected contact,
/// geometrically beyond. Where a' ends with a jump, at the rim of a nose, there is a station too.
template <class Append>
void lay_stations(const Sections& nose, const StationPlan& plan, Append&& append) {
  // Least width of the cell inside the rim over its depth: its strains must differ by more than rounding.
  constexpr double min_rim = 1e-6;
  const bool has_rim = nose.depth < plan.reach && nose.rate(nose.depth) > 0;
  const double end = std::min(plan.reach, nose.depth);
  const double widest = plan.spacing.even * plan.resolution * std::min(plan.expected, end);
  const double of_gap = plan.spacing.of_gap * plan.resolution;
  double first = plan.spacing.first * widest;
  if (nose.shape && nose.shape->is_steep_at_tip()) first *= plan.spacing.even * plan.resolution;
  const auto spacing = [&](double depth) {
    return std::min({std::max(widest, plan.resolution * (depth - plan.expected)), of_gap * (plan.gap + depth),
                     plan.spacing.of_depth * plan.resolution * depth});
  };
  std::size_t count = 1;
  append(0.0);
  KnotsAhead knots(nose);
  for (double depth = knots.stop(std::min(first, of_gap * plan.gap), 0);
       depth < end * (1 - (has_rim ? min_rim : 1e-9)) && count < max_stations; ++count) {
    append(depth);
    const double step = spacing(depth);
    depth = knots.stop(depth + step, step);
  }
  if (has_rim && count < max_stations) append(end);
}

}  // namespace dashpad
