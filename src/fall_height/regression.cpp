// A figure over the height of the drop: least squares in logarithms.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "dashpad/fall_height/fall_height.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::fall_height {

namespace {

std::array<double, 3> powers_of(double x) { return {1, x, x * x}; }

Curve fitted_with(std::span<const Point> points, int terms, double middle) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd factors(rows, terms);
  Eigen::VectorXd logs(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Point& point = points[static_cast<std::size_t>(i)];
    const auto powers = powers_of(std::log(point.height / middle));
    for (int j = 0; j < terms; ++j) factors(i, j) = powers[static_cast<std::size_t>(j)];
    logs(i) = std::log(point.value);
  }
  const Eigen::VectorXd solution = factors.colPivHouseholderQr().solve(logs);
  const Eigen::MatrixXd cofactors = (factors.transpose() * factors).inverse();
  Curve curve{.terms = terms, .middle = middle};
  for (int i = 0; i < terms; ++i) {
    curve.coefficients[static_cast<std::size_t>(i)] = solution(i);
    for (int j = 0; j < terms; ++j)
      curve.cofactors[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = cofactors(i, j);
  }
  curve.freedom = points.size() - static_cast<std::size_t>(terms);
  if (curve.freedom > 0)
    curve.deviation =
        std::sqrt((factors * solution - logs).squaredNorm() / static_cast<double>(curve.freedom));
  return curve;
}

/// Whether the last coefficient differs from 0 with 95 %.
bool bends(const Curve& curve) {
  const double deviation = curve.deviation * std::sqrt(curve.cofactors[2][2]);
  return std::abs(curve.coefficients[2]) >
         uncertainty::student_95(static_cast<double>(curve.freedom)) * deviation;
}

}  // namespace

double Curve::at(double height) const {
  const double x = std::log(height / middle);
  return std::exp(coefficients[0] + x * (coefficients[1] + x * coefficients[2]));
}

double Curve::half_width(double height) const {
  if (freedom == 0) return std::numeric_limits<double>::infinity();
  const auto powers = powers_of(std::log(height / middle));
  double variance = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) variance += powers[i] * cofactors[i][j] * powers[j];
  return uncertainty::student_95(static_cast<double>(freedom)) * deviation * std::sqrt(variance);
}

std::optional<Curve> fitted(std::span<const Point> points) {
  std::vector<double> heights;
  double logs = 0;
  for (const Point& point : points) {
    heights.push_back(point.height);
    logs += std::log(point.height) / static_cast<double>(points.size());
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  if (heights.size() < 2) return std::nullopt;
  const Curve straight = fitted_with(points, 2, std::exp(logs));
  if (heights.size() < 4 || points.size() < 5) return straight;
  const Curve bent = fitted_with(points, 3, std::exp(logs));
  return points.size() > 5 || bends(bent) ? bent : straight;
}

}  // namespace dashpad::fall_height
