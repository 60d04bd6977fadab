#pragma once
/// All placings of strains and forces at once. There are far too many to visit; sums over a placing's points
/// are least along a path through the tests, by dynamic programming.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "dashpad/report1986/validation/trends.hpp"

namespace dashpad::report1986 {

/// The least sum over the points of a placing.
struct LeastSum {
  double sum = 0;
  std::vector<NominalStressPoint> points;
};

class NominalStressPlacings {
 public:
  /// Tests with strain and force make points. `stress` is the nominal stress of a test with its readings
  /// placed.
  NominalStressPlacings(const MeasuredTests& measured,
                        const std::function<double(const MeasuredTest&)>& stress);

  /// The placing with the least sum of cost(ln(force / stress)) for each number of points that a placing may
  /// have.
  [[nodiscard]] std::map<std::size_t, LeastSum> least(const std::function<double(double)>& cost) const;

 private:
  /// A way to serve one test: from how many readings placed before, to how many after it.
  struct Step {
    std::size_t from = 0, to = 0;
    bool has_point = false;
    NominalStressPoint point;
  };
  std::vector<std::vector<Step>> steps_;  ///< for each test
  std::vector<std::size_t> states_;       ///< how many there are before each test, and after the last
};

}  // namespace dashpad::report1986
