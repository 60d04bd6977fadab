#pragma once
/// Curves of a solved impact, as other programs take them: pairs of numbers with x strictly increasing. SI.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad::output {

struct CurveAxis {
  std::string meaning;  ///< "time"
  std::string si_unit;  ///< "s"
};

/// y over x; x is strictly increasing, and no two points are nearer than smallest_gap of the largest x.
struct Curve {
  std::string name;  ///< one of curve_names()
  CurveAxis abscissa;
  CurveAxis ordinate;
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// A single point is no curve to any program.
  [[nodiscard]] bool exists() const { return x.size() >= 2; }
};

/// Of the largest x. Nearer points could not be told apart in single precision, with which some decks are
/// solved; of those that are left out, none is further from one that is kept.
inline constexpr double smallest_gap = 1e-6;

/// Largest part of the largest penetration over which a sudden fall of the force is spread, so that the force
/// stays a function of the penetration.
inline constexpr double widest_fall = 1e-3;

/// force, acceleration, velocity, motion, penetration: over time. loading, unloading: force over penetration.
const std::vector<std::string>& curve_names();

/// The curve of that name. Throws std::invalid_argument for another name. Signs are those of History.
Curve curve(const std::string& name, const Solution& solution);

/// Force over penetration from first contact to the largest penetration. Where the pad is held or springs
/// back for a while, the points up to the next new largest penetration are left out: each penetration has
/// the force with which it was first reached. So a pad that is fully compressed on a yielding support ends
/// the curve; the force beyond that belongs to the support.
Curve loading_branch(const History& history);

/// Force over penetration from the largest penetration back to release, given over increasing penetration.
/// Each penetration has the force with which it was last passed; the force is 0 from no penetration to that
/// of release, and at the largest penetration that of the loading branch. Where the force falls while the
/// pad is held at the largest penetration, the fall is spread over the last widest_fall of it, or over half
/// the way to the point before where that is less. Does not exist unless the impactor was released.
Curve unloading_branch(const Solution& solution);

struct ThinnedCurve {
  Curve curve;
  double error = 0;  ///< largest distance in y from the curve before, both taken as linear between points
};

/// At most `most_points` (2 or more) points of the curve: its ends, and one by one the point that is furthest
/// off.
ThinnedCurve thinned(const Curve& curve, std::size_t most_points);

}  // namespace dashpad::output
