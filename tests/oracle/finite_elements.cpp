#include "oracle/finite_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace dashpad::oracle {

namespace {

using Eigen::Index;

/// Pressed with its Young's modulus, foam gives way into the nose by this share of the topmost elements.
constexpr double give_share = 1e-3;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// F = U diag(l1, l2) V of the plane part: the directions in which F changes, as rows over (rr, rz, zr, zz,
/// hoop): the two stretches, the hoop, a turn of both together, a shear of the stretched.
struct Stretches {
  Eigen::Vector3d l;
  Eigen::Matrix<double, 5, 5> directions = Eigen::Matrix<double, 5, 5>::Zero();
};

Stretches stretches_of(const Eigen::Matrix<double, 5, 1>& f) {
  const double sum = f[0] + f[3], difference = f[0] - f[3], skew = f[2] - f[1], shear = f[2] + f[1];
  const double mean = std::hypot(sum, skew) / 2, spread = std::hypot(difference, shear) / 2;
  const double turn = std::atan2(skew, sum), axis = std::atan2(shear, difference);
  const double u = (turn + axis) / 2, v = (turn - axis) / 2;
  Eigen::Matrix2d left, right;
  left << std::cos(u), -std::sin(u), std::sin(u), std::cos(u);
  right << std::cos(v), -std::sin(v), std::sin(v), std::cos(v);
  const auto product = [&](Index i, Index j) {
    return Eigen::Vector4d(left(0, i) * right(j, 0), left(0, i) * right(j, 1), left(1, i) * right(j, 0),
                           left(1, i) * right(j, 1));
  };
  Stretches s;
  s.l = {mean + spread, mean - spread, f[4]};
  s.directions.row(0).head<4>() = product(0, 0);
  s.directions.row(1).head<4>() = product(1, 1);
  s.directions(2, 4) = 1;
  s.directions.row(3).head<4>() = (product(1, 0) - product(0, 1)) / std::numbers::sqrt2;
  s.directions.row(4).head<4>() = (product(1, 0) + product(0, 1)) / std::numbers::sqrt2;
  return s;
}

/// The second derivatives of W along the directions above. Those of turn and shear follow from the slopes,
/// since W knows the stretches only.
Eigen::Matrix<double, 5, 5> stiffness_along(const StretchEnergy& w, const Eigen::Vector3d& l, bool convex) {
  Eigen::Matrix<double, 5, 5> h = Eigen::Matrix<double, 5, 5>::Zero();
  h.topLeftCorner<3, 3>() = w.curvature;
  const double apart = l[0] - l[1];
  h(3, 3) = (w.slope[0] + w.slope[1]) / (l[0] + l[1]);
  h(4, 4) = apart > 1e-6 ? (w.slope[0] - w.slope[1]) / apart
                         : (w.curvature(0, 0) + w.curvature(1, 1)) / 2 - w.curvature(0, 1);
  if (convex)
    for (const Index i : {3, 4}) h(i, i) = std::max(h(i, i), 0.0);
  return h;
}

}  // namespace

double Hyperfoam::young_modulus() const {
  double sum = 0;
  for (const Term& term : terms) sum += term.shear_modulus;
  return 2 * (1 + poisson_ratio) * sum;
}

double Hyperfoam::column_stress(double strain) const {
  double stress = 0;
  for (const auto& [mu, a] : terms)
    stress += 2 * mu / a * (std::pow(1 - strain, -1 - a * poisson_ratio) - std::pow(1 - strain, a - 1));
  return stress;
}

StretchEnergy stretch_energy(const Hyperfoam& foam, const Eigen::Vector3d& l) {
  const double b = foam.poisson_ratio / (1 - 2 * foam.poisson_ratio);
  const Eigen::Vector3d inverse = l.cwiseInverse();
  const Eigen::Array3d log = l.array().log();
  StretchEnergy w;
  for (const auto& [mu, a] : foam.terms) {
    // Less 1 each, so that small strains do not drown in rounding.
    const Eigen::Array3d power = (a * log).unaryExpr([](double x) { return std::expm1(x); });
    const double volume = std::expm1(-a * b * log.sum()), scale = 2 * mu / a;
    w.value += scale / a * (power.sum() + (b > 0 ? volume / b : -a * log.sum()));
    w.slope += scale * ((power - volume) * inverse.array()).matrix();
    w.curvature += scale * a * b * (1 + volume) * inverse * inverse.transpose();
    w.curvature.diagonal() += scale * ((a + (a - 1) * power + volume) * inverse.array().square()).matrix();
  }
  return w;
}

std::vector<double> graded(double step, double even, double end, double ratio) {
  const auto count = std::max(1.0, std::round(even / step));
  std::vector<double> places;
  for (double i = 0; i <= count; ++i) places.push_back(even * i / count);
  std::vector<double> beyond;
  double reach = 0;
  for (double grown = even / count; even + reach < end * (1 - 1e-9); reach += grown) {
    grown *= ratio;
    beyond.push_back(reach + grown);
  }
  for (const double place : beyond) places.push_back(even + place * (end - even) / reach);
  return places;
}

MeshedPad::MeshedPad(Hyperfoam foam, RigidNose nose, Floor floor, std::vector<double> radii,
                     std::vector<double> depths)
    : foam_(std::move(foam)),
      nose_(nose),
      radii_(std::move(radii)),
      depths_(std::move(depths)),
      penalty_(foam_.young_modulus() / (give_share * depths_[1])) {
  const auto unknowns = static_cast<Index>(2 * radii_.size() * depths_.size());
  x_.resize(unknowns);
  stuck_.setConstant(unknowns, false);
  fixed_ = stuck_;
  for (std::size_t column = 0; column < radii_.size(); ++column) {
    surface_.push_back({radius_of(column, 0), 0});
    for (std::size_t row = 0; row < depths_.size(); ++row) {
      const Index r = radius_of(column, row), z = r + 1;
      x_[r] = radii_[column];
      x_[z] = depths_.back() - depths_[row];
      fixed_[z] = row + 1 == depths_.size();
      fixed_[r] = column == 0 || (fixed_[z] && floor == Floor::bonded);
    }
  }
  for (std::size_t column = 0; column + 1 < radii_.size(); ++column) {
    for (std::size_t row = 0; row + 1 < depths_.size(); ++row) add_element(column, row);
    const double inner = radii_[column], outer = radii_[column + 1];
    if (nose_.shape == RigidShape::flat_disc && outer > nose_.radius * (1 + 1e-9)) continue;
    surface_[column].area += std::numbers::pi / 3 * (outer - inner) * (2 * inner + outer);
    surface_[column + 1].area += std::numbers::pi / 3 * (outer - inner) * (inner + 2 * outer);
  }
}

void MeshedPad::add_element(std::size_t column, std::size_t row) {
  const double width = radii_[column + 1] - radii_[column], height = depths_[row + 1] - depths_[row];
  for (const double a : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)})
    for (const double b : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)}) {
      const double radius = radii_[column] + a * width;
      Point point{{}, Eigen::Matrix<double, 5, 8>::Zero(), std::numbers::pi / 2 * radius * width * height};
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::size_t right = corner / 2, below = corner % 2;
        const double of_a = right == 1 ? a : 1 - a, of_b = below == 1 ? b : 1 - b;
        const double by_r = (right == 1 ? of_b : -of_b) / width, by_z = (below == 1 ? -of_a : of_a) / height;
        const auto r = static_cast<Index>(2 * corner), z = r + 1;
        point.unknowns[2 * corner] = radius_of(column + right, row + below);
        point.unknowns[2 * corner + 1] = point.unknowns[2 * corner] + 1;
        point.gradient(0, r) = point.gradient(2, z) = by_r;
        point.gradient(1, r) = point.gradient(3, z) = by_z;
        point.gradient(4, r) = of_a * of_b / radius;
      }
      points_.push_back(point);
    }
}

double MeshedPad::inside_nose(const SurfaceNode& node, const Vector& x) const {
  const double r = x[node.radius], height = x[node.radius + 1];
  const double tip = depths_.back() - depth_;
  if (node.area == 0) return -infinite;
  if (nose_.shape == RigidShape::flat_disc) return height - tip;
  if (r >= nose_.radius) return -infinite;
  return height - tip - nose_.radius + std::sqrt(nose_.radius * nose_.radius - r * r);
}

double MeshedPad::energy(const Vector& x) const {
  double sum = 0;
  for (const Point& point : points_) {
    const Stretches s = stretches_of(point.gradient * x(point.unknowns));
    if (s.l.minCoeff() <= 0) return infinite;
    sum += point.volume * stretch_energy(foam_, s.l).value;
  }
  for (const SurfaceNode& node : surface_) {
    const double p = std::max(inside_nose(node, x), 0.0);
    sum += penalty_ * node.area * p * p / 2;
  }
  return sum;
}

bool MeshedPad::factorize(bool convex) {
  slope_.setZero(x_.size());
  entries_.clear();
  const auto held = [&](Index i) { return fixed_[i] || stuck_[i]; };
  // Entries of what is held stay as zeros, so that the pattern is the same throughout.
  const auto add = [&](Index i, Index j, double value) {
    if (i >= j) entries_.emplace_back(i, j, held(i) || held(j) ? 0 : value);
  };
  for (const Point& point : points_) {
    const Stretches s = stretches_of(point.gradient * x_(point.unknowns));
    const StretchEnergy w = stretch_energy(foam_, s.l);
    const Eigen::Matrix<double, 5, 8> along = s.directions * point.gradient;
    const Eigen::Matrix<double, 8, 8> stiffness =
        point.volume * along.transpose() * stiffness_along(w, s.l, convex) * along;
    slope_(point.unknowns) += point.volume * along.topRows<3>().transpose() * w.slope;
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j)
        add(point.unknowns[i], point.unknowns[j], stiffness(static_cast<Index>(i), static_cast<Index>(j)));
  }
  for (const SurfaceNode& node : surface_) {
    const double p = inside_nose(node, x_), k = penalty_ * node.area;
    if (p <= 0) continue;
    const Index r = node.radius, z = r + 1;
    double steepness = 0, bend = 0;  // of p by r
    if (nose_.shape == RigidShape::sphere) {
      const double drop = std::sqrt(nose_.radius * nose_.radius - x_[r] * x_[r]);
      steepness = -x_[r] / drop;
      bend = -nose_.radius * nose_.radius / (drop * drop * drop);
    }
    slope_[r] += k * p * steepness;
    slope_[z] += k * p;
    add(r, r, k * (steepness * steepness + (convex ? 0 : p * bend)));
    add(z, r, k * steepness);
    add(z, z, k);
  }
  for (Index i = 0; i < x_.size(); ++i) {
    entries_.emplace_back(i, i, held(i) ? 1 : 0);
    if (held(i)) slope_[i] = 0;
  }
  stiffness_.resize(x_.size(), x_.size());
  stiffness_.setFromTriplets(entries_.begin(), entries_.end());
  if (solver_.rows() == 0) solver_.analyzePattern(stiffness_);
  solver_.factorize(stiffness_);
  return solver_.info() == Eigen::Success && solver_.vectorD().minCoeff() > 0;
}

void MeshedPad::settle() {
  double now = energy(x_);
  // A dozen do.
  for (int iteration = 0; iteration < 30; ++iteration) {
    if (!factorize(false) && !factorize(true)) break;
    const Vector direction = -solver_.solve(slope_);
    const double gain = -slope_.dot(direction);
    double length = 1, then = energy(x_ + direction);
    // Close by, the step goes on whatever the energy: rounding, or a node that just misses the nose, would
    // stop it.
    while (gain > 1e-8 * now && !(then <= now - 1e-4 * length * gain) && length > 1e-6) {
      length /= 2;
      then = energy(x_ + length * direction);
    }
    if (!std::isfinite(then)) break;
    x_ += length * direction;
    now = then;
    // That step was Newton's own, so that about twice as many digits are right now.
    if (gain < 1e-11 * now) return;
  }
  throw std::runtime_error("no equilibrium of the foam found");
}

double MeshedPad::press(double depth, double step) {
  const double from = depth_;
  const double steps = std::ceil((depth - from) / step * (1 - 1e-9));
  for (double i = 1; i <= steps; ++i) {
    if (nose_.face == Face::rough)
      for (const SurfaceNode& node : surface_) stuck_[node.radius] = inside_nose(node, x_) >= 0;
    depth_ = from + (depth - from) * i / steps;
    settle();
  }
  double force = 0;
  for (const SurfaceNode& node : surface_)
    force += penalty_ * node.area * std::max(inside_nose(node, x_), 0.0);
  return force;
}

}  // namespace dashpad::oracle
