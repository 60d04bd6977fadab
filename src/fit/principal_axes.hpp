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

}  // namespace dashpad::fit
