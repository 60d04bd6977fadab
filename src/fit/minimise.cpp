#include "fit/determine.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <Eigen/QR>

namespace dashpad::fit {
namespace {

/// Relative change of the coordinates at which a fit has converged: far below what noise moves.
constexpr double min_change_of_place = 1e-9;
/// The same with impacts, and changes of the misfit towards a coarse and towards a fine minimum.
constexpr double min_change_with_impacts = 1e-5, coarse_with_impacts = 1e-4, fine_with_impacts = 1e-5;
/// The largest step for one-sided differences, which suffice towards a coarse minimum, as with impacts.
constexpr double longest_one_sided = 1e-3;

using ResidualsAt = std::function<bool(std::span<double> x, std::span<double> residuals)>;

/// Derivatives with respect to one coordinate.
bool column(const LeastSquares& problem, const ResidualsAt& residuals_at, std::span<const double> x,
            std::size_t i, std::span<double> into) {
  const double h = problem.step;
  const double at = x[i];
  const auto evaluate = [&](double to, std::span<double> residuals) {
    std::vector<double> there(x.begin(), x.end());
    there[i] = to;
    return residuals_at(there, residuals);
  };
  std::vector<double> one(problem.residuals), two(problem.residuals);
  const bool fits_below = at - h >= 0, fits_above = at + h <= 1;
  if (fits_below && fits_above && evaluate(at + h, one) && evaluate(at - h, two)) {
    for (std::size_t k = 0; k < into.size(); ++k) into[k] = (one[k] - two[k]) / (2 * h);
    return true;
  }
  // At a bound, or at the end of valid materials, differences are one-sided.
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

/// The same one-sided, towards the farther bound. False where the model ends there.
bool short_column(const LeastSquares& problem, const ResidualsAt& residuals_at, std::span<const double> x,
                  std::size_t i, std::span<const double> here, std::span<double> into) {
  std::vector<double> there(x.begin(), x.end());
  const double step = x[i] < 0.5 ? problem.step : -problem.step;
  there[i] += step;
  const bool sound = residuals_at(there, into);
  for (std::size_t k = 0; sound && k < into.size(); ++k) into[k] = (into[k] - here[k]) / step;
  return sound;
}

/// Fills the columns of a matrix, row by row, with `column`(k, values); false once that is.
template <class Column>
bool fill_columns(const LeastSquares& problem, std::size_t count, double* matrix, Column&& column) {
  std::atomic<bool> is_sound = true;
  const auto fill = [&](std::size_t i) {
    std::vector<double> one(problem.residuals);
    // All columns are evaluated, even after a failure: the number must not depend on the threads.
    if (!column(i, std::span<double>(one)))
      is_sound = false;
    else
      for (std::size_t k = 0; k < one.size(); ++k) matrix[k * count + i] = one[k];
  };
  if (problem.takes_impacts)
    tbb::parallel_for(std::size_t{0}, count, fill);
  else
    for (std::size_t i = 0; i < count && is_sound; ++i) fill(i);
  return is_sound;
}

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

/// A search by the method of Levenberg and Marquardt whose steps keep within the bounds.
class Search {
 public:
  Search(const LeastSquares& problem, Minimum& minimum, double tolerance, std::vector<bool> held)
      : problem_(problem), minimum_(minimum), held_(std::move(held)), residuals_(rows()) {
    held_.resize(minimum.x.size(), false);
    for (std::size_t i = 0; i < minimum.x.size(); ++i)
      if (!held_[i] && !(problem.settle && problem.settles[i])) free_.push_back(i);
    one_sided_ = tolerance >= coarse && (problem.takes_impacts || problem.step <= longest_one_sided);
    const double floor = tolerance >= coarse ? coarse_with_impacts : fine_with_impacts;
    tolerance_ = problem.takes_impacts ? std::max(tolerance, floor) : tolerance;
    min_change_ = problem.takes_impacts ? min_change_with_impacts : min_change_of_place;
  }

  void run(int iterations) {
    if (!residuals_at(minimum_.x, residuals_)) {
      minimum_.why_not =
          "the model cannot be evaluated at the starting values: they do not give a valid material, or a "
          "simulated impact lacks a figure that was measured, for example because the pad bottoms out";
      return;
    }
    minimum_.misfit = residuals_.squaredNorm();
    minimum_.is_sound = true;
    minimum_.converged = free_.empty();
    for (int i = 0; i < iterations && !minimum_.converged && minimum_.is_sound; ++i) iterate();
    if (!minimum_.converged && minimum_.why_not.empty())
      minimum_.why_not = fmt::format("the search did not converge within {} steps", iterations);
  }

 private:
  [[nodiscard]] Eigen::Index rows() const { return static_cast<Eigen::Index>(problem_.residuals); }
  [[nodiscard]] Eigen::Index columns() const { return static_cast<Eigen::Index>(free_.size()); }
  [[nodiscard]] double place(Eigen::Index i) const { return minimum_.x[free_[static_cast<std::size_t>(i)]]; }

  bool residuals_at(std::span<double> x, Vector& residuals) const {
    return residuals_at(x, std::span<double>(residuals.data(), problem_.residuals));
  }
  bool residuals_at(std::span<double> x, std::span<double> residuals) const {
    return problem_.settle ? problem_.settle(x, held_, residuals) : problem_.evaluate(x, residuals);
  }

  /// Makes one step that reduces the misfit, or ends the search.
  void iterate() {
    if (!is_fresh_ && !is_updated_ && !differentiate())
      return stop("a step from these values does not give a valid material");
    // Each try is damped more; after these nothing is left of a step, as where the search was stopped.
    constexpr int max_tries = 30;
    for (int tries = 0; tries < max_tries; ++tries) {
      const Vector step = step_from_here();
      if (step.lpNorm<Eigen::Infinity>() < min_change_) return refresh_or_converge();
      const Vector expected = residuals_ + jacobian_ * step;
      std::vector<double> x = minimum_.x;
      for (Eigen::Index i = 0; i < columns(); ++i) {
        double& at = x[free_[static_cast<std::size_t>(i)]];
        at = std::clamp(at + step[i], 0.0, 1.0);
      }
      Vector residuals(rows());
      const bool is_sound = residuals_at(x, residuals);
      const double misfit = is_sound ? residuals.squaredNorm() : 0;
      const double gain = (minimum_.misfit - misfit) / (minimum_.misfit - expected.squaredNorm());
      if (is_sound && misfit < minimum_.misfit && gain > min_gain) {
        const bool is_last = minimum_.misfit - misfit <= tolerance_ * minimum_.misfit;
        take(std::move(x), step, std::move(residuals), expected, misfit, gain);
        if (is_last) refresh_or_converge();
        return;
      }
      if (!is_fresh_) {
        // The derivatives may be to blame.
        is_updated_ = false;
        return;
      }
      damping_ *= growth_;
      growth_ *= 2;
      if (minimum_.misfit - expected.squaredNorm() <= tolerance_ * minimum_.misfit && is_sound)
        return refresh_or_converge();
    }
    stop("no step from the best values gives a material for which the model can be evaluated");
  }

  void take(std::vector<double> x, const Vector& step, Vector residuals, const Vector& expected,
            double misfit, double gain) {
    damping_ *= std::max(1.0 / 5, 1 - std::pow(2 * gain - 1, 3));
    growth_ = 2;
    // Broyden's update, where impacts make derivatives dear and the old ones were good.
    is_updated_ = problem_.takes_impacts && std::abs(gain - 1) < good_gain;
    if (is_updated_) jacobian_ += (residuals - expected) * step.transpose() / step.squaredNorm();
    is_fresh_ = false;
    minimum_.x = std::move(x);
    minimum_.misfit = misfit;
    residuals_ = std::move(residuals);
  }

  void refresh_or_converge() {
    if (is_fresh_ || !is_updated_) {
      minimum_.converged = true;
    } else {
      is_updated_ = false;
    }
  }
  void stop(const char* why) {
    minimum_.is_sound = false;
    minimum_.why_not = why;
  }

  bool differentiate() {
    jacobian_.resize(rows(), columns());
    const std::span<const double> here(residuals_.data(), problem_.residuals);
    const ResidualsAt at = [this](std::span<double> x, std::span<double> r) { return residuals_at(x, r); };
    is_fresh_ =
        fill_columns(problem_, free_.size(), jacobian_.data(), [&](std::size_t i, std::span<double> one) {
          return (one_sided_ && short_column(problem_, at, minimum_.x, free_[i], here, one)) ||
                 column(problem_, at, minimum_.x, free_[i], one);
        });
    return is_fresh_;
  }

  /// The damped step; what would leave the bounds ends there, and the others take it into account.
  [[nodiscard]] Vector step_from_here() {
    if (scale_.size() == 0) scale_ = Vector::Zero(columns());
    scale_ = scale_.cwiseMax(jacobian_.colwise().norm().transpose());
    const double largest = std::max(scale_.maxCoeff(), 1e-300);
    const Vector gradient = jacobian_.transpose() * residuals_;
    Vector step = Vector::Zero(columns());
    std::vector<Eigen::Index> moving;
    for (Eigen::Index i = 0; i < columns(); ++i) {
      const bool leaves = gradient[i] > 0 ? place(i) <= 0 : place(i) >= 1;
      if (!leaves) moving.push_back(i);
    }
    while (!moving.empty()) {
      const auto n = static_cast<Eigen::Index>(moving.size());
      Matrix system = Matrix::Zero(rows() + n, n);
      Vector target(rows() + n);
      Vector fixed = step;
      for (const Eigen::Index i : moving) fixed[i] = 0;
      target << -(residuals_ + jacobian_ * fixed), Vector::Zero(n);
      for (Eigen::Index k = 0; k < n; ++k) {
        system.col(k).head(rows()) = jacobian_.col(moving[static_cast<std::size_t>(k)]);
        system(rows() + k, k) =
            std::sqrt(damping_) * std::max(scale_[moving[static_cast<std::size_t>(k)]], min_scale * largest);
      }
      const Vector found = system.householderQr().solve(target);
      std::vector<Eigen::Index> still;
      for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::Index i = moving[static_cast<std::size_t>(k)];
        step[i] = std::clamp(found[k], -place(i), 1 - place(i));
        if (step[i] == found[k]) still.push_back(i);
      }
      if (still.size() == moving.size()) break;
      moving = std::move(still);
    }
    return step;
  }

  static constexpr double min_gain = 1e-4;  ///< least ratio of actual to expected gain of a step
  static constexpr double good_gain = 0.3;  ///< largest difference of that ratio from 1 that allows an update
  static constexpr double min_scale = 1e-6;

  const LeastSquares& problem_;
  Minimum& minimum_;
  std::vector<bool> held_;
  std::vector<std::size_t> free_;
  bool one_sided_ = false;
  double tolerance_ = 0, min_change_ = 0;
  Vector residuals_;
  Matrix jacobian_;
  bool is_fresh_ = false, is_updated_ = false;  ///< derivatives: of this place, or carried over to it
  Vector scale_;
  double damping_ = 1e-3, growth_ = 2;
};

}  // namespace

bool derivatives(const LeastSquares& problem, std::span<const double> x, std::span<double> into) {
  return fill_columns(problem, x.size(), into.data(), [&](std::size_t i, std::span<double> one) {
    return column(problem, problem.evaluate, x, i, one);
  });
}

Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance,
                 const std::vector<bool>& held, int iterations) {
  Minimum minimum;
  minimum.x = std::move(start);
  Search(problem, minimum, tolerance, held).run(iterations);
  return minimum;
}

}  // namespace dashpad::fit
