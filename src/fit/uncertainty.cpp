#include "fit/determine.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace dashpad::fit {

namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double strong_correlation = 0.95;
/// Share of a unit vector from which on a coordinate belongs to a flat direction.
constexpr double min_share = 0.3;
/// Eigenvalues below this share of the largest are rounding of the differences.
constexpr double min_eigenvalue = 1e-11;

struct Curvature {
  Eigen::VectorXd values;  ///< eigenvalues of J'J, at least min_eigenvalue times the largest
  Matrix vectors;
  Matrix inverse;
};

Curvature curvature_of(const Matrix& hessian) {
  const Eigen::Index n = hessian.rows();
  const PrincipalAxes axes =
      principal_axes({hessian.data(), static_cast<std::size_t>(hessian.size())}, static_cast<std::size_t>(n));
  Curvature curvature;
  curvature.vectors = Eigen::Map<const Eigen::MatrixXd>(axes.directions.data(), n, n);
  curvature.values = Eigen::Map<const Eigen::VectorXd>(axes.values.data(), n);
  const double least = min_eigenvalue * std::max(curvature.values.maxCoeff(), 1e-300);
  curvature.values = curvature.values.cwiseMax(least);
  curvature.inverse =
      curvature.vectors * curvature.values.cwiseInverse().asDiagonal() * curvature.vectors.transpose();
  return curvature;
}

void find_flat_directions(const Curvature& curvature, const std::vector<std::size_t>& free, double scale,
                          Uncertainty& into) {
  for (Eigen::Index k = 0; k < curvature.values.size(); ++k) {
    if (curvature.values[k] >= scale) continue;
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < free.size(); ++i)
      if (std::abs(curvature.vectors(static_cast<Eigen::Index>(i), k)) > min_share)
        members.push_back(free[i]);
    into.flat_directions.push_back(members);
  }
}

void find_correlations(const Matrix& covariance, const std::vector<std::size_t>& free, Uncertainty& into) {
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const double of = covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
      if (std::abs(of) <= strong_correlation) continue;
      into.strongly_correlated.emplace_back(free[static_cast<std::size_t>(j)],
                                            free[static_cast<std::size_t>(i)]);
      into.correlations.push_back(of);
    }
}

}  // namespace

bool is_at_bound(double x) { return x < 1e-6 || x > 1 - 1e-6; }

Autocorrelation autocorrelation_of(std::span<const double> residuals) {
  const auto n = static_cast<double>(residuals.size());
  double products = 0;
  double squares = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    squares += residuals[i] * residuals[i];
    if (i > 0) products += residuals[i] * residuals[i - 1];
  }
  Autocorrelation of{squares > 0 ? std::min(products / squares, 0.999) : 0, n};
  // The correlation rho of independent residuals scatters by 1 / sqrt(n).
  if (of.rho > 2 / std::sqrt(n)) of.effective_points = std::max(n * (1 - of.rho) / (1 + of.rho), 1.0);
  return of;
}

bool find_uncertainty(const Problem& problem, const LeastSquares& residuals, std::span<const double> x,
                      double scale, Uncertainty& into) {
  const auto p = static_cast<Eigen::Index>(x.size());
  const auto n = static_cast<Eigen::Index>(residuals.residuals);
  Matrix jacobian(n, p);
  Eigen::VectorXd r(n);
  if (!residuals.evaluate(x, {r.data(), residuals.residuals})) return false;
  if (!derivatives(residuals, x, {jacobian.data(), static_cast<std::size_t>(jacobian.size())})) return false;

  into = {};
  Matrix widened = jacobian.transpose() * jacobian;  // will include the weights of the blocks
  const Matrix hessian = widened;
  for (const Block& block : problem.blocks) {
    const auto first = static_cast<Eigen::Index>(block.first),
               count = static_cast<Eigen::Index>(block.size());
    const auto single = static_cast<Eigen::Index>(block.curve.value_or(block.size()));
    const auto along = count - single;
    Autocorrelation of{0, static_cast<double>(along)};
    if (along > 0) of = autocorrelation_of({r.data() + first + single, static_cast<std::size_t>(along)});
    const double weight = along > 0 ? static_cast<double>(along) / of.effective_points : 1;
    const auto rows = jacobian.middleRows(first + single, along);
    if (weight > 1) widened += (weight - 1) * (rows.transpose() * rows);
    into.blocks.push_back(of);
  }
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!is_at_bound(x[i])) free.push_back(i);
  const auto free_count = static_cast<Eigen::Index>(free.size());
  Matrix own(free_count, free_count), own_widened(free_count, free_count);
  for (Eigen::Index i = 0; i < free_count; ++i)
    for (Eigen::Index j = 0; j < free_count; ++j) {
      const auto a = static_cast<Eigen::Index>(free[static_cast<std::size_t>(i)]);
      const auto b = static_cast<Eigen::Index>(free[static_cast<std::size_t>(j)]);
      own(i, j) = hessian(a, b);
      own_widened(i, j) = widened(a, b);
    }
  into.error.resize(x.size());
  into.widening.assign(x.size(), 1);
  into.covariance.assign(x.size() * x.size(), 0);
  if (free_count > 0) {
    const Curvature curvature = curvature_of(own);
    const Matrix naive = scale * curvature.inverse;
    const Matrix covariance = naive + scale * (curvature.inverse * (own_widened - own) * curvature.inverse);
    for (Eigen::Index i = 0; i < free_count; ++i) {
      const std::size_t at = free[static_cast<std::size_t>(i)];
      into.widening[at] = std::max(covariance(i, i) / naive(i, i), 1.0);
      if (covariance(i, i) < 1) into.error[at] = std::sqrt(covariance(i, i));
      for (Eigen::Index j = 0; j < free_count; ++j)
        into.covariance[at * x.size() + free[static_cast<std::size_t>(j)]] = covariance(i, j);
    }
    find_flat_directions(curvature, free, scale, into);
    find_correlations(covariance, free, into);
  }
  // Draws use all coordinates, with one widening for all of them.
  const double mean_widening = widened.trace() / std::max(hessian.trace(), 1e-300);
  const Matrix precision = hessian / (scale * mean_widening);
  into.precision.assign(precision.data(), precision.data() + precision.size());
  const Eigen::VectorXd gradient = jacobian.transpose() * r / (scale * mean_widening);
  into.gradient.assign(gradient.data(), gradient.data() + gradient.size());
  return true;
}

}  // namespace dashpad::fit
