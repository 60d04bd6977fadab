#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "dashpad/report1986/validation/nose_radius.hpp"
#include "uncertainty/student.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double step_in = 0.25;

/// The least sum of squares between the radii: the vertex of the parabola through three of them.
struct Least {
  std::size_t index = 0;
  double radius_in = 0;
  double sum = 0;
};

Least least_of(const std::vector<double>& radii, const std::vector<double>& sums) {
  Least least{0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] < least.sum) least = {i, radii[i], sums[i]};
  const std::size_t i = least.index;
  if (i == 0 || i + 1 == radii.size() || std::isnan(sums[i - 1]) || std::isnan(sums[i + 1])) return least;
  const double bend = sums[i - 1] - 2 * sums[i] + sums[i + 1];
  if (!(bend > 0)) return least;
  const double shift = (sums[i - 1] - sums[i + 1]) / (2 * bend);
  least.radius_in += shift * step_in;
  least.sum = std::max(0.0, sums[i] - bend * shift * shift / 2);
  return least;
}

/// No radius with a figure is left on one side of the least sum.
bool is_at_an_end(const std::vector<double>& sums, std::size_t least) {
  const auto has_figure = [](double sum) { return !std::isnan(sum); };
  const auto place = sums.begin() + static_cast<std::ptrdiff_t>(least);
  return std::none_of(sums.begin(), place, has_figure) || std::none_of(place + 1, sums.end(), has_figure);
}

/// Where the sum of squares crosses the limit, from the least one towards an end of the range; a radius
/// without a figure forbids nothing.
double border(const std::vector<double>& radii, const std::vector<double>& sums, const Least& least,
              double limit, int direction) {
  double radius = least.radius_in, sum = least.sum;
  for (auto i = static_cast<std::ptrdiff_t>(least.index); i >= 0 && i < std::ssize(radii); i += direction) {
    const auto at = static_cast<std::size_t>(i);
    if ((radii[at] - least.radius_in) * direction <= 0 || std::isnan(sums[at])) continue;
    if (sums[at] > limit) return radius + (radii[at] - radius) * (limit - sum) / (sums[at] - sum);
    radius = radii[at], sum = sums[at];
  }
  return direction < 0 ? radii.front() : radii.back();
}

/// Sum of squares; NaN where a reading has no figure.
double sum_of_squares(const std::vector<std::optional<double>>& residuals) {
  double sum = 0;
  for (const std::optional<double>& residual : residuals) {
    if (!residual) return std::numeric_limits<double>::quiet_NaN();
    sum += *residual * *residual;
  }
  return sum;
}

}  // namespace

std::vector<double> radii_of_the_study() {
  std::vector<double> radii;
  for (int i = 0; least_radius_in + i * step_in <= greatest_radius_in; ++i)
    radii.push_back(least_radius_in + i * step_in);
  return radii;
}

RadiusCriterion radius_criterion(
    std::string name, std::string remark, std::string unit,
    const std::function<std::vector<std::optional<double>>(double radius_in)>& residuals_at) {
  RadiusCriterion criterion;
  criterion.name = std::move(name);
  criterion.remark = std::move(remark);
  criterion.unit = std::move(unit);
  const std::vector<double> radii = radii_of_the_study();
  std::vector<double> sums;
  for (const double radius : radii) {
    const auto residuals = residuals_at(radius);
    criterion.readings = static_cast<int>(residuals.size());
    sums.push_back(residuals.empty() ? std::numeric_limits<double>::quiet_NaN() : sum_of_squares(residuals));
    criterion.misfit.push_back(std::sqrt(sums.back() / criterion.readings));
  }
  const Least least = least_of(radii, sums);
  criterion.favoured_in = std::round(100 * least.radius_in) / 100;
  criterion.at_an_end = std::isfinite(least.sum) && is_at_an_end(sums, least.index);
  criterion.admitted = {radii.front(), radii.back()};
  const auto missing = std::ranges::count_if(sums, [](double sum) { return std::isnan(sum); });
  if (missing > 0) criterion.remark += fmt::format("; no figure at {} of {} radii", missing, radii.size());
  if (criterion.readings < 2 || std::ssize(radii) - missing < 3) return criterion;
  const int freedom = criterion.readings - 1;
  const double quantile = std::pow(uncertainty::student_95(freedom), 2);  // of F(1, freedom)
  const double limit = least.sum * (1 + quantile / freedom);
  criterion.admitted = {border(radii, sums, least, limit, -1), border(radii, sums, least, limit, 1)};
  return criterion;
}

}  // namespace dashpad::report1986
