#pragma once
/// Where the columns of a contact stand: depths from the axis outwards, closer towards the axis, which is
/// touched first and carries the steepest stress when the gap closes (theory.md, section 3, Stations).
///
/// Lengths in m.

#include <algorithm>
#include <cstddef>

#include "dashpad/model/nose/sections.hpp"

namespace dashpad {

/// Spacing of the stations, in the resolution rho of a run (theory.md, section 4). None of these is physics:
/// with a finer resolution the integral tends to the same value whatever they are.
struct StationSpacing {
  double even = 0.8;    ///< of the contact that is expected, between two stations
  double first = 0.2;   ///< of that, from the axis to the first station off it (no rho)
  double of_gap = 8;    ///< of the gap above a station: the stress at the axis grows over the gap
  double of_depth = 3;  ///< of the depth of a station: those near the axis are touched first
  double graded = 4;    ///< gaps from the axis within which stations are added as the gap closes (no rho)
};
inline constexpr StationSpacing station_spacing;

/// Stations for which there is memory. A run that would want more has left some out, and is none.
inline constexpr std::size_t most_stations = 20'000;

/// What the stations are to suit.
struct StationPlan {
  double resolution = 0;
  double expected = 0;  ///< largest penetration that is expected
  double reach = 0;     ///< depth up to which columns may be met
  double gap = 0;       ///< between nose and support on the axis
};

/// Columns stand where a' jumps: at each knot of a shape in turn.
class KnotsAhead {
 public:
  explicit KnotsAhead(const Sections& nose) {
    if (!nose.shape) return;
    next_ = nose.shape->knots().data();
    end_ = next_ + nose.shape->knots().size();
  }
  /// The next knot, if it is not much farther than the depth to which a step leads; else that depth.
  double stop(double depth, double step) {
    if (next_ == end_ || *next_ > depth + 0.3 * step) return depth;
    return *next_++;
  }

 private:
  const double* next_ = nullptr;
  const double* end_ = nullptr;
};

/// Calls append(depth) for each station, at most `most_stations` times: evenly as far as the contact is
/// expected to grow, geometrically beyond. Where a' ends with a jump, at the rim of a nose that is cut off,
/// there is a station too.
template <class Append>
void lay_stations(const Sections& nose, const StationPlan& plan, Append&& append) {
  // Cell between the rim and the next column, of the rim's depth: strains in it differ by more than rounding.
  constexpr double least_rim = 1e-6;
  const bool has_rim = nose.depth < plan.reach && nose.rate(nose.depth) > 0;
  const double end = std::min(plan.reach, nose.depth);
  const double widest = station_spacing.even * plan.resolution * std::min(plan.expected, end);
  const double of_gap = station_spacing.of_gap * plan.resolution;
  double first = station_spacing.first * widest;
  if (nose.shape && nose.shape->is_steep_at_tip()) first *= station_spacing.even * plan.resolution;
  const auto spacing = [&](double depth) {
    return std::min({std::max(widest, plan.resolution * (depth - plan.expected)), of_gap * (plan.gap + depth),
                     station_spacing.of_depth * plan.resolution * depth});
  };
  std::size_t count = 1;
  append(0.0);
  KnotsAhead knots(nose);
  for (double depth = knots.stop(std::min(first, of_gap * plan.gap), 0);
       depth < end * (1 - (has_rim ? least_rim : 1e-9)) && count < most_stations; ++count) {
    append(depth);
    const double step = spacing(depth);
    depth = knots.stop(depth + step, step);
  }
  if (has_rim && count < most_stations) append(end);
}

}  // namespace dashpad
