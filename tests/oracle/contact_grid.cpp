#include "oracle/contact_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dashpad::oracle {

GridPoint grid_point(double z, Grading grading) {
  const double scale = std::log1p(1 / grading.axis);
  const double w = grading.axis * std::expm1(z * scale);
  const double w_slope = grading.axis * scale * std::exp(z * scale);
  const double left = z >= 1 ? 0 : std::fmax(0, 1 - w);
  GridPoint point;
  point.rest = std::pow(left, grading.edge);
  point.share = z <= 0 ? 0 : -std::expm1(grading.edge * std::log1p(-std::fmin(w, 1)));
  if (left == 0) point.share = 1;
  point.slope = grading.edge * std::pow(left, grading.edge - 1) * w_slope;
  return point;
}

double grid_coordinate(double rest, Grading grading) {
  const double w = 1 - std::pow(rest, 1 / grading.edge);
  return std::log1p(w / grading.axis) / std::log1p(1 / grading.axis);
}

ChebyshevGrid::ChebyshevGrid(int count, Grading grades) : grading(grades) {
  const int last = count - 1;
  const auto size = static_cast<std::size_t>(count);
  for (int i = 0; i < count; ++i) {
    const double half_angle = std::numbers::pi * i / (2.0 * last);
    z.push_back(std::sin(half_angle) * std::sin(half_angle));
    points.push_back(grid_point(z.back(), grading));
    barycentric.push_back((i % 2 == 0 ? 1.0 : -1.0) * (i == 0 || i == last ? 0.5 : 1.0));
  }
  for (int i = 0; i < count; ++i) {  // Clenshaw-Curtis on [0, 1]
    double sum = 1;
    for (int k = 1; 2 * k <= last; ++k) {
      const double factor = 2 * k == last ? 1 : 2;
      sum -= factor * std::cos(2 * std::numbers::pi * k * i / last) / (4.0 * k * k - 1);
    }
    const double weight = (i == 0 || i == last ? 0.5 : 1.0) * sum / last;
    weights.push_back(weight * points[static_cast<std::size_t>(i)].slope);
  }
  differentiate.assign(size * size, 0);
  for (std::size_t i = 0; i + 1 < size; ++i) {
    double diagonal = 0;
    for (std::size_t j = 0; j < size; ++j) {
      if (j == i) continue;
      // z_i - z_j = sin((a+b)/2) sin((a-b)/2) with the angles of the points.
      const double a = std::numbers::pi * static_cast<double>(i) / last;
      const double b = std::numbers::pi * static_cast<double>(j) / last;
      const double distance = std::sin((a + b) / 2) * std::sin((a - b) / 2);
      const double entry = barycentric[j] / barycentric[i] / distance / points[i].slope;
      differentiate[i * size + j] = entry;
      diagonal -= entry;
    }
    differentiate[i * size + i] = diagonal;
  }
}

double ChebyshevGrid::interpolate(const std::vector<double>& values, double z_wanted) const {
  double numerator = 0;
  double denominator = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double distance = z_wanted - z[i];
    if (distance == 0) return values[i];
    numerator += barycentric[i] * values[i] / distance;
    denominator += barycentric[i] / distance;
  }
  return numerator / denominator;
}

namespace {

/// Consecutive positive nodes.
struct Run {
  int first = 0;
  int last = 0;
};

/// Nodes of a local polynomial: up to four of the run, around an interval.
struct Stencil {
  int start = 0;
  int size = 0;
};

Stencil stencil_of(const Run& run, int interval) {
  Stencil stencil;
  stencil.size = std::min(4, run.last - run.first + 1);
  stencil.start = std::clamp(interval - 1, run.first, run.last + 1 - stencil.size);
  return stencil;
}

/// Lagrange's basis polynomials of the nodes 0, 1, .. size - 1.
std::array<double, 4> basis(int size, double x) {
  switch (size) {
    case 1: return {1, 0, 0, 0};
    case 2: return {1 - x, x, 0, 0};
    case 3: return {(x - 1) * (x - 2) / 2, x * (2 - x), x * (x - 1) / 2, 0};
    default:
      return {-(x - 1) * (x - 2) * (x - 3) / 6, x * (x - 2) * (x - 3) / 2, -x * (x - 1) * (x - 3) / 2,
              x * (x - 1) * (x - 2) / 6};
  }
}

/// How far beyond the node `inside` the values fall to zero, in the direction `way`; at most one node.
double reach(const Run& run, const double* values, int inside, int way) {
  const Stencil stencil = stencil_of(run, way > 0 ? inside : inside - 1);
  if (stencil.size == 1) return 0.5;
  const auto at = [&](double beyond) {
    const auto share = basis(stencil.size, inside - stencil.start + way * beyond);
    double sum = 0;
    for (int k = 0; k < stencil.size; ++k)
      sum += share[static_cast<std::size_t>(k)] * values[stencil.start + k];
    return sum;
  };
  double positive = 0, negative = 1;
  double f_positive = values[inside], f_negative = at(1);
  if (f_negative >= 0) return 1;
  double x = 0;
  for (int k = 0; k < 60 && negative - positive > 1e-15; ++k) {  // Illinois
    x = (positive * f_negative - negative * f_positive) / (f_negative - f_positive);
    const double f = at(x);
    if (std::fabs(f) < 1e-14 * (values[inside] - f_negative)) break;
    if (f > 0) {
      positive = x, f_positive = f, f_negative /= 2;
    } else {
      negative = x, f_negative = f, f_positive /= 2;
    }
  }
  return x;
}

void add_part(const Run& run, int interval, double from, double to, std::vector<double>& weights) {
  const Stencil stencil = stencil_of(run, interval);
  const double middle = interval - stencil.start + (from + to) / 2;
  const double half = (to - from) / 2;
  for (const double gauss : {-std::numbers::inv_sqrt3, std::numbers::inv_sqrt3}) {
    const auto share = basis(stencil.size, middle + gauss * half);
    const auto start = static_cast<std::size_t>(stencil.start);
    for (std::size_t k = 0; k < static_cast<std::size_t>(stencil.size); ++k)
      weights[start + k] += half * share[k];
  }
}

}  // namespace

void PositiveParts::find(const double* g, const std::vector<char>& usable) {
  std::fill(weights_.begin(), weights_.end(), 0.0);
  runs_ = 0;
  const auto count = static_cast<int>(weights_.size());
  const auto positive = [&](int i) { return usable[static_cast<std::size_t>(i)] && g[i] > 0; };
  for (int i = 0; i < count; ++i) {
    if (!positive(i)) continue;
    Run run{i, i};
    while (run.last + 1 < count && positive(run.last + 1)) ++run.last;
    i = run.last;
    ++runs_;
    for (int k = run.first; k < run.last; ++k) add_part(run, k, 0, 1, weights_);
    if (run.last + 1 < count) add_part(run, run.last, 0, reach(run, g, run.last, +1), weights_);
    if (run.first > 0) add_part(run, run.first - 1, 1 - reach(run, g, run.first, -1), 1, weights_);
  }
}

}  // namespace dashpad::oracle
