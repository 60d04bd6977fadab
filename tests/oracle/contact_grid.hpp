#pragma once
/// Where the columns of the CVODE oracle stand, and how their stresses add up to a force.
///
/// Depth s from the axis, s in [0, Y], as a share x = s/Y of a coordinate z in [0, 1]:
///   x = 1 - (1 - w)^k,   w = g (exp(z ln(1 + 1/g)) - 1)
/// which clusters columns towards the axis (bottoming; g is the share of the depth that gets its own scale)
/// and, with the power k, towards the contact edge, where the stress is a fractional power of Y - s.

#include <vector>

namespace dashpad::oracle {

struct Grading {
  double axis = 0.05;  ///< g, > 0
  double edge = 2;     ///< k, >= 1
};

/// One place on the grid.
struct GridPoint {
  double share = 0;  ///< x = s/Y
  double rest = 1;   ///< 1 - x, without cancellation
  double slope = 1;  ///< dx/dz
};
GridPoint grid_point(double z, Grading grading);
/// z at a given 1 - x.
double grid_coordinate(double rest, Grading grading);

/// Chebyshev points with what a spectral method needs of them.
struct ChebyshevGrid {
  ChebyshevGrid(int count, Grading grades);

  Grading grading;
  std::vector<double> z;  ///< increasing, 0 to 1
  std::vector<GridPoint> points;
  std::vector<double> weights;  ///< of the integral over x (Clenshaw-Curtis times dx/dz)
  std::vector<double> barycentric;
  std::vector<double> differentiate;  ///< d/dx, row by row; the last row (dx/dz = 0) is left at 0

  /// The polynomial through `values` at a coordinate.
  [[nodiscard]] double interpolate(const std::vector<double>& values, double z_wanted) const;
};

/// Weights of the integral, over a uniform row of nodes with unit spacing, of a quantity f where another one
/// g is positive. g may be positive in several places: a contact can be a ring, or a ring around a disc. Each
/// run of positive nodes reaches, beyond its ends, to the root of the cubic through its own outermost four
/// nodes, by at most one node; a column that has let go is not asked, its law has no meaning much longer.
/// Inside a run the integral is cubic in each interval (order 4).
class PositiveParts {
 public:
  explicit PositiveParts(int count) : weights_(static_cast<std::size_t>(count)) {}
  /// Only nodes with `usable` count.
  void find(const double* g, const std::vector<char>& usable);
  /// 0 for a node outside all runs.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  [[nodiscard]] bool empty() const { return runs_ == 0; }
  [[nodiscard]] int runs() const { return runs_; }

 private:
  std::vector<double> weights_;
  int runs_ = 0;
};

}  // namespace dashpad::oracle
