#include "fit/posterior.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <boost/math/distributions/normal.hpp>

#include "fit/principal_axes.hpp"
#include "study/random.hpp"

namespace dashpad::fit {

namespace {

/// Sweeps over all directions between two draws: without bounds one would do.
constexpr int sweeps_between_draws = 20;
constexpr double flat_curvature = 1e-9;  ///< of a direction, over a move across the bounds

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

std::vector<std::vector<double>> laplace_sample(std::span<const double> minimum,
                                                std::span<const double> precision,
                                                std::span<const double> gradient, std::size_t count,
                                                std::uint64_t seed) {
  const auto n = static_cast<Eigen::Index>(minimum.size());
  const Eigen::Map<const Eigen::VectorXd> centre(minimum.data(), n);
  Eigen::MatrixXd P = Eigen::Map<const Eigen::MatrixXd>(precision.data(), n, n);  // symmetric
  Eigen::VectorXd g = Eigen::Map<const Eigen::VectorXd>(gradient.data(), n);
  if (!P.allFinite() || !g.allFinite()) {  // nothing is known but the bounds
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
