#include "fit/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/principal_axes.hpp"

namespace dashpad::fit {

namespace {

constexpr int runs_of_prediction = 4;

}  // namespace

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

}  // namespace dashpad::fit
