#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace dashpad::fit {

/// Eigenvalues of a symmetric matrix, rising, and their directions of length 1.
struct PrincipalAxes {
  std::vector<double> values;
  std::vector<double> directions;  ///< one after the other

  [[nodiscard]] std::span<const double> direction(std::size_t k) const {
    return {directions.data() + k * values.size(), values.size()};
  }
};

/// `matrix` holds `size` rows of `size` numbers.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const double> matrix, std::size_t size);

/// Of a covariance of coordinates from 0 to 1, the standard deviation along an axis. A direction of which the
/// data say nothing counts as even between the bounds.
[[nodiscard]] double deviation_along(const PrincipalAxes& axes, std::size_t k);

}  // namespace dashpad::fit
