// Predictions and draws from the covariance of a minimum.

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <boost/math/distributions/normal.hpp>

#include "fit/determine.hpp"
#include "study/sampling.hpp"

namespace dashpad::fit {
namespace {

constexpr int runs_of_prediction = 4;

/// Sweeps over all directions between two draws: without bounds one would do.
constexpr int sweeps_between_draws = 20;
constexpr double flat_curvature = 1e-9;  ///< curvature of a flat direction, over a move across the bounds

/// A number from exp(-curvature t^2 / 2 - slope t), low <= t <= high, at a fraction of its distribution.
double draw_along(double curvature, double slope, double low, double high, double fraction) {
  if (!(high > low)) return 0;
  if (curvature < flat_curvature) {
    if (std::abs(slope) * (high - low) < 1e-9) return low + fraction * (high - low);
    const double k = slope * (high - low);
    return low - std::log1p(fraction * std::expm1(-k)) / slope;
  }
  const boost::math::normal normal(-slope / curvature, 1 / std::sqrt(curvature));
  // The tail nearer to the mean keeps its digits.
  if (low > normal.mean()) {
    const double from = cdf(complement(normal, low)), to = cdf(complement(normal, high));
    const double q = from + fraction * (to - from);
    return q > 0 ? std::clamp(quantile(complement(normal, q)), low, high) : low;
  }
  const double from = cdf(normal, low), to = cdf(normal, high);
  const double q = from + fraction * (to - from);
  return q > 0 && q < 1 ? std::clamp(quantile(normal, q), low, high) : high;
}

}  // namespace

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

std::vector<std::optional<double>> prediction_deviations(const Fit& fit, const ImpactMeasurement& impact,
                                                         const Problem& problem, std::span<const double> x,
                                                         const Uncertainty& uncertainty) {
  ImpactMeasurement alone = impact;
  alone.pulse.reset();
  const Predict predict = prediction_of(fit, alone, runs_of_prediction);
  const std::size_t count = impact.figures.size();
  /// No numbers where the impact has no such figure, or is none.
  const auto at = [&](std::span<const double> place) {
    std::vector<double> figures(count);
    if (!predict(problem.values(place), figures)) figures.assign(count, no_figure);
    return figures;
  };
  const std::vector<double> here = at(x);
  const std::size_t n = x.size();
  const PrincipalAxes axes = principal_axes(uncertainty.covariance, n);
  std::vector<double> variance(count, 0);
  for (std::size_t k = 0; k < n; ++k) {
    const double deviation = deviation_along(axes, k);
    if (deviation == 0) continue;
    // Differences over what stays of the way within the bounds.
    std::vector<double> way(count, 0), difference(count, 0);
    for (const double side : {1.0, -1.0}) {
      std::vector<double> place(x.begin(), x.end());
      double share = 1;
      // Rounding must not move a coordinate at a bound, of which the covariance knows nothing.
      const auto axis = [&](std::size_t i) {
        return uncertainty.covariance[i * n + i] > 0 ? axes.direction(k)[i] : 0.0;
      };
      for (std::size_t i = 0; i < n; ++i) {
        const double step = side * deviation * axis(i);
        const double room = step > 0 ? 1 - place[i] : place[i];
        if (std::abs(step) > room) share = std::min(share, room / std::abs(step));
      }
      for (std::size_t i = 0; i < n; ++i)
        place[i] = std::clamp(place[i] + share * side * deviation * axis(i), 0.0, 1.0);
      const std::vector<double> there = at(place);
      for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(there[i])) continue;
        way[i] += share;
        difference[i] += side * (there[i] - here[i]);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      if (way[i] >= 0.01) variance[i] += difference[i] * difference[i] / (way[i] * way[i]);
  }
  std::vector<std::optional<double>> deviations(count);
  for (std::size_t i = 0; i < count; ++i)
    if (std::isfinite(here[i])) deviations[i] = std::sqrt(variance[i]);
  return deviations;
}

std::vector<std::vector<double>> laplace_sample(std::span<const double> minimum,
                                                std::span<const double> precision,
                                                std::span<const double> gradient, std::size_t count,
                                                std::uint64_t seed) {
  const auto n = static_cast<Eigen::Index>(minimum.size());
  const Eigen::Map<const Eigen::VectorXd> centre(minimum.data(), n);
  Eigen::MatrixXd P = Eigen::Map<const Eigen::MatrixXd>(precision.data(), n, n);  // symmetric
  Eigen::VectorXd g = Eigen::Map<const Eigen::VectorXd>(gradient.data(), n);
  if (!P.allFinite() || !g.allFinite()) {  // only the bounds are known
    P.setZero();
    g.setZero();
  }
  const PrincipalAxes axes = principal_axes({P.data(), static_cast<std::size_t>(P.size())}, minimum.size());
  Eigen::VectorXd x = centre;
  std::vector<std::vector<double>> draws;
  std::uint64_t step = 0;
  for (std::size_t draw = 0; draw < count; ++draw) {
    for (int sweep = 0; sweep < sweeps_between_draws; ++sweep, ++step)
      for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::Map<const Eigen::VectorXd> along(axes.direction(static_cast<std::size_t>(k)).data(), n);
        double low = -1e300, high = 1e300;
        for (Eigen::Index i = 0; i < n; ++i) {
          if (std::abs(along[i]) < 1e-14) continue;
          const double a = -x[i] / along[i], b = (1 - x[i]) / along[i];
          low = std::max(low, std::min(a, b));
          high = std::min(high, std::max(a, b));
        }
        const Eigen::VectorXd pulled = P * along;
        const double slope = pulled.dot(x - centre) + g.dot(along);
        const double fraction =
            study::random_fraction(seed, step, static_cast<std::uint32_t>(k), study::Purpose::draw);
        x += draw_along(std::max(pulled.dot(along), 0.0), slope, low, high, fraction) * along;
        x = x.cwiseMax(0.0).cwiseMin(1.0);
      }
    draws.emplace_back(x.data(), x.data() + n);
  }
  return draws;
}

}  // namespace dashpad::fit
