#pragma once
/// The way of a column through a measured test.

#include <cstddef>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/laboratory/strain_history.hpp"

namespace dashpad::fit {

struct TestPath {
  laboratory::StrainHistory history;
  /// For each point of the test how many pieces lead to it; 0: it is the start, at stress 0.
  std::vector<std::size_t> pieces_to;
};

/// Straight through the points, strains below 0 as 0. A test whose first strain is above 0 is led there from
/// 0 at the mean rate of the test.
TestPath path_of(const MaterialMeasurement& test);

/// Mean magnitude of the strain rate while the strain moves, 1/s.
double mean_rate_of(const MaterialMeasurement& test);

}  // namespace dashpad::fit
