#include "fit/principal_axes.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace dashpad::fit {

PrincipalAxes principal_axes(std::span<const double> matrix, std::size_t size) {
  if (size == 0) return {};
  const auto n = static_cast<Eigen::Index>(size);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(
      Eigen::Map<const Eigen::MatrixXd>(matrix.data(), n, n));
  const Eigen::VectorXd& values = found.eigenvalues();
  const Eigen::MatrixXd& directions = found.eigenvectors();
  return {{values.begin(), values.end()}, {directions.data(), directions.data() + directions.size()}};
}

double deviation_along(const PrincipalAxes& axes, std::size_t k) {
  const double of_even = std::sqrt(1.0 / 12);
  return std::min(std::sqrt(std::max(axes.values[k], 0.0)), of_even);
}

}  // namespace dashpad::fit
