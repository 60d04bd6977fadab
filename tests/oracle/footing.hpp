#pragma once
/// The support of the general oracle, written anew from theory.md, Eqs. 4, 41 and 43.

#include <algorithm>
#include <cmath>
#include <vector>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::oracle {

class Footing {
 public:
  Footing(const Support& support, const Backing& backing, double impactor_mass) : backing_(backing) {
    points_.push_back({});
    for (const Support::Point& point : support.points()) points_.push_back(point);
    if (is_rigid()) return;
    damping_ = backing.damping;
    if (backing.loss_factor > 0)
      damping_ = backing.loss_factor * std::sqrt(slope_at(0) * (impactor_mass + backing.mass));
    offset_ = -backing.gap;
    if (backing.preload > 0) offset_ = yield_ = deflection(backing.preload);
    if (backing.earlier_force > 0) {
      yield_ = deflection(backing.earlier_force);
      offset_ = yield_ - backing.earlier_force / backing.unloading_stiffness;
    }
    first_yield_ = yield_, first_force_ = force(0);
  }
  [[nodiscard]] bool is_rigid() const { return points_.size() == 1; }
  [[nodiscard]] double damping() const { return damping_; }
  void set_damping(double damping) { damping_ = damping; }
  [[nodiscard]] bool crushes() const { return backing_.unloading_stiffness > 0; }

  /// Fs, N, and its slope, N/m, at the deflection x.
  [[nodiscard]] double force(double x) const {
    const double z = x + offset_;
    if (z >= yield_ || !crushes()) return curve(z);
    return std::fmax(curve(yield_) - backing_.unloading_stiffness * (yield_ - z), 0);
  }
  [[nodiscard]] double slope(double x) const {
    const double z = x + offset_;
    return z >= yield_ || !crushes() ? slope_at(z) : backing_.unloading_stiffness;
  }
  /// x at a force that it has not had before, m.
  [[nodiscard]] double deflection_at(double force) const { return deflection(force) - offset_; }
  /// By the number of the straight piece of the curve that is in force: the slope, N/m, and how far it goes
  /// on up and down, m.
  [[nodiscard]] std::size_t piece(double x) const { return segment(x + offset_); }
  [[nodiscard]] double slope_of(std::size_t piece) const { return slope_at(points_[piece].deflection); }
  [[nodiscard]] double up(std::size_t piece, double x) const {
    return piece + 2 < points_.size() ? points_[piece + 1].deflection - offset_ - x : 1;
  }
  [[nodiscard]] double down(std::size_t piece, double x) const {
    return piece > 0 ? x + offset_ - points_[piece].deflection : 1;
  }
  /// The end of a step, and where the support turns.
  void reached(double x) { yield_ = std::fmax(yield_, x + offset_); }
  /// By how much x is beyond all before, m.
  [[nodiscard]] double beyond(double x) const { return x + offset_ - yield_; }
  /// What stays, m, from where a preload holds it.
  [[nodiscard]] double set() const {
    const double rest = backing_.preload > 0 ? offset_ : 0;
    return crushes() ? std::fmax(yield_ - curve(yield_) / backing_.unloading_stiffness - rest, 0) : 0;
  }
  /// What the support at x still gives, J.
  [[nodiscard]] double energy_left(double x) const {
    const double z = x + offset_;
    return crushes() && z < yield_ ? force(x) * force(x) / (2 * backing_.unloading_stiffness) : energy(z);
  }
  /// What it has been given on the way to x, lost or not, J.
  [[nodiscard]] double taken(double x) const {
    if (!crushes()) return energy(x + offset_) - energy(offset_);
    const auto back = [&](double value) { return value * value / (2 * backing_.unloading_stiffness); };
    return energy(yield_) - energy(first_yield_) - back(curve(yield_)) + back(curve(first_yield_)) +
           back(force(x)) - back(first_force_);
  }

 private:
  [[nodiscard]] std::size_t segment(double z) const {
    std::size_t i = 0;
    while (i + 2 < points_.size() && points_[i + 1].deflection <= z) ++i;
    return i;
  }
  [[nodiscard]] double slope_at(double z) const {
    const std::size_t i = segment(z);
    return (points_[i + 1].force - points_[i].force) / (points_[i + 1].deflection - points_[i].deflection);
  }
  [[nodiscard]] double curve(double z) const {
    if (z <= 0) return 0;
    const std::size_t i = segment(z);
    return points_[i].force + slope_at(z) * (z - points_[i].deflection);
  }
  /// Below the curve, J.
  [[nodiscard]] double energy(double z) const {
    double sum = 0;
    for (std::size_t i = 0; z > 0 && i <= segment(z); ++i) {
      const double to = i == segment(z) ? z : points_[i + 1].deflection;
      sum += (points_[i].force + curve(to)) / 2 * (to - points_[i].deflection);
    }
    return sum;
  }
  [[nodiscard]] double deflection(double force) const {
    std::size_t i = 0;
    while (i + 2 < points_.size() && points_[i + 1].force <= force) ++i;
    return points_[i].deflection + (force - points_[i].force) / slope_at(points_[i].deflection);
  }

  Backing backing_;
  std::vector<Support::Point> points_;
  double damping_ = 0;
  double offset_ = 0;                         ///< deflection of the curve where x is 0, m
  double yield_ = 0;                          ///< largest deflection of the curve so far, m
  double first_yield_ = 0, first_force_ = 0;  ///< at the begin
};

}  // namespace dashpad::oracle
