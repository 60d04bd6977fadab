// The only source that knows Ceres (docs/decisions/0015-fits-with-ceres.md).

#include "fit/solve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <ceres/ceres.h>
#include <glog/logging.h>

namespace dashpad::fit {

namespace {

/// Relative change of the coordinates at which a fit has converged: far below what noise moves.
constexpr double least_change_of_place = 1e-9;
constexpr int most_iterations = 300;
/// Up to this step one-sided differences are good enough on the way to a coarse minimum, at half the
/// evaluations.
constexpr double longest_one_sided = 1e-3;

double sum_of_squares(std::span<const double> values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

/// Derivatives with respect to one coordinate.
bool column(const LeastSquares& problem, std::vector<double>& x, std::size_t i, std::span<double> into) {
  const double h = problem.step;
  const double at = x[i];
  const auto evaluate = [&](double to, std::span<double> residuals) {
    x[i] = to;
    const bool sound = problem.evaluate(x, residuals);
    x[i] = at;
    return sound;
  };
  std::vector<double> one(problem.residuals), two(problem.residuals);
  const bool fits_below = at - h >= 0, fits_above = at + h <= 1;
  if (fits_below && fits_above && evaluate(at + h, one) && evaluate(at - h, two)) {
    for (std::size_t k = 0; k < into.size(); ++k) into[k] = (one[k] - two[k]) / (2 * h);
    return true;
  }
  // At a bound, or where the model ends.
  std::vector<double> here(problem.residuals);
  if (!evaluate(at, here)) return false;
  for (const double side : {1.0, -1.0}) {
    if (at + 2 * side * h > 1 || at + 2 * side * h < 0) continue;
    if (!evaluate(at + side * h, one) || !evaluate(at + 2 * side * h, two)) continue;
    for (std::size_t k = 0; k < into.size(); ++k)
      into[k] = side * (4 * one[k] - two[k] - 3 * here[k]) / (2 * h);
    return true;
  }
  return false;
}

/// The problem over the coordinates that are not held, for Ceres.
class FreeResiduals final : public ceres::CostFunction {
 public:
  FreeResiduals(const LeastSquares& problem, std::vector<double> x, std::vector<std::size_t> free,
                bool one_sided)
      : problem_(problem), x_(std::move(x)), free_(std::move(free)), one_sided_(one_sided) {
    set_num_residuals(static_cast<int>(problem.residuals));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free_.size()));
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    std::vector<double> x = x_;
    for (std::size_t i = 0; i < free_.size(); ++i) x[free_[i]] = std::clamp(parameters[0][i], 0.0, 1.0);
    const std::size_t count = problem_.residuals;
    if (!problem_.evaluate(x, {residuals, count})) return false;
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    std::vector<double> one(count);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const bool is_short = one_sided_ && short_column(x, free_[i], {residuals, count}, one);
      if (!is_short && !column(problem_, x, free_[i], one)) return false;
      for (std::size_t k = 0; k < count; ++k) jacobians[0][k * free_.size() + i] = one[k];
    }
    return true;
  }

 private:
  /// Towards the farther bound. False where the model ends there.
  bool short_column(std::vector<double>& x, std::size_t i, std::span<const double> here,
                    std::span<double> into) const {
    const double at = x[i];
    const double step = at < 0.5 ? problem_.step : -problem_.step;
    x[i] = at + step;
    const bool sound = problem_.evaluate(x, into);
    x[i] = at;
    for (std::size_t k = 0; sound && k < into.size(); ++k) into[k] = (into[k] - here[k]) / step;
    return sound;
  }

  const LeastSquares& problem_;
  std::vector<double> x_;
  std::vector<std::size_t> free_;
  bool one_sided_;
};

}  // namespace

bool derivatives(const LeastSquares& problem, std::span<const double> x, std::span<double> into) {
  std::vector<double> at(x.begin(), x.end()), one(problem.residuals);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!column(problem, at, i, one)) return false;
    for (std::size_t k = 0; k < one.size(); ++k) into[k * at.size() + i] = one[k];
  }
  return true;
}

Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance,
                 const std::vector<bool>& held) {
  FLAGS_minloglevel = google::FATAL;  // what goes wrong is in the result
  Minimum minimum{false, "", std::move(start), 0};
  std::vector<double> residuals(problem.residuals);
  if (!problem.evaluate(minimum.x, residuals)) {
    minimum.why_not =
        "the model cannot be evaluated at the starting values: they make no valid material, or an impact "
        "without the measured figure, as where the pad bottoms out";
    return minimum;
  }
  minimum.misfit = sum_of_squares(residuals);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < minimum.x.size(); ++i)
    if (held.empty() || !held[i]) free.push_back(i);
  if (free.empty()) {
    minimum.converged = true;
    return minimum;
  }
  std::vector<double> y;
  for (const std::size_t i : free) y.push_back(minimum.x[i]);
  const bool one_sided = tolerance >= coarse && problem.step <= longest_one_sided;
  ceres::Problem least_squares;
  least_squares.AddResidualBlock(new FreeResiduals(problem, minimum.x, free, one_sided), nullptr, y.data());
  for (int i = 0; i < static_cast<int>(free.size()); ++i) {
    least_squares.SetParameterLowerBound(y.data(), i, 0);
    least_squares.SetParameterUpperBound(y.data(), i, 1);
  }
  ceres::Solver::Options options;
  options.logging_type = ceres::SILENT;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = tolerance;
  options.parameter_tolerance = least_change_of_place;
  options.gradient_tolerance = 1e-12;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &least_squares, &summary);
  for (std::size_t i = 0; i < free.size(); ++i) minimum.x[free[i]] = std::clamp(y[i], 0.0, 1.0);
  minimum.converged = summary.termination_type == ceres::CONVERGENCE;
  if (!minimum.converged) minimum.why_not = summary.message;
  if (problem.evaluate(minimum.x, residuals)) minimum.misfit = sum_of_squares(residuals);
  return minimum;
}

}  // namespace dashpad::fit
