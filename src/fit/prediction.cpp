#include "fit/prediction.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace dashpad::fit {

namespace {

/// Standard deviation of what is even between 0 and 1.
const double deviation_of_even = std::sqrt(1.0 / 12);
constexpr int runs_of_prediction = 4;

}  // namespace

std::optional<double> prediction_deviation(const Fit& fit, const ImpactMeasurement& impact,
                                           const MeasuredFigure& figure, const Problem& problem,
                                           std::span<const double> x, const Uncertainty& uncertainty) {
  ImpactMeasurement one = impact;
  one.figures = {figure};
  one.pulse.reset();
  const Predict predict = prediction_of(fit, one, runs_of_prediction);
  const auto at = [&](std::span<const double> place) -> std::optional<double> {
    double value = 0;
    if (!predict(problem.values(place), {&value, 1})) return std::nullopt;
    return value;
  };
  const std::optional<double> here = at(x);
  if (!here) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::MatrixXd> covariance(uncertainty.covariance.data(), n, n);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(covariance);
  double variance = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double deviation = std::min(std::sqrt(std::max(axes.eigenvalues()[k], 0.0)), deviation_of_even);
    if (deviation == 0) continue;
    // Differences over what stays of the way within the bounds.
    double way = 0, difference = 0;
    for (const double side : {1.0, -1.0}) {
      std::vector<double> place(x.begin(), x.end());
      double share = 1;
      for (Eigen::Index i = 0; i < n; ++i) {
        const double step = side * deviation * axes.eigenvectors()(i, k);
        const double room =
            step > 0 ? 1 - place[static_cast<std::size_t>(i)] : place[static_cast<std::size_t>(i)];
        if (std::abs(step) > room) share = std::min(share, room / std::abs(step));
      }
      for (Eigen::Index i = 0; i < n; ++i)
        place[static_cast<std::size_t>(i)] = std::clamp(
            place[static_cast<std::size_t>(i)] + share * side * deviation * axes.eigenvectors()(i, k), 0.0,
            1.0);
      const std::optional<double> there = at(place);
      if (!there) continue;
      way += share;
      difference += side * (*there - *here);
    }
    if (way < 0.01) continue;
    variance += difference * difference / (way * way);
  }
  return std::sqrt(variance);
}

}  // namespace dashpad::fit
