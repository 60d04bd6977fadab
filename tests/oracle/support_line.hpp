#pragma once
/// The support as the CVODE oracle sees it: one straight segment at a time.

#include <cstddef>
#include <vector>

#include "dashpad/model/support/support.hpp"

namespace dashpad::oracle {

class SupportLine {
 public:
  explicit SupportLine(const Support& support) : points_(support.points()) {
    points_.insert(points_.begin(), Support::Point{});
  }
  [[nodiscard]] bool rigid() const { return points_.size() == 1; }
  /// N/m, of the segment in force.
  [[nodiscard]] double stiffness() const {
    const auto& low = points_[segment_];
    const auto& high = points_[segment_ + 1];
    return (high.force - low.force) / (high.deflection - low.deflection);
  }
  [[nodiscard]] double force(double deflection) const {
    return points_[segment_].force + stiffness() * (deflection - points_[segment_].deflection);
  }
  /// Deflection at a force, on the segment in force.
  [[nodiscard]] double deflection(double force) const {
    return points_[segment_].deflection + (force - points_[segment_].force) / stiffness();
  }
  /// Distance from the corner above; positive before it, and always on the last segment.
  [[nodiscard]] double to_corner_above(double deflection) const {
    return segment_ + 2 < points_.size() ? points_[segment_ + 1].deflection - deflection : 1;
  }
  /// Distance from the corner below; the origin is none.
  [[nodiscard]] double to_corner_below(double deflection) const {
    return segment_ > 0 ? deflection - points_[segment_].deflection : 1;
  }
  void next_segment() { ++segment_; }
  void last_segment() { --segment_; }

 private:
  std::vector<Support::Point> points_;
  std::size_t segment_ = 0;
};

}  // namespace dashpad::oracle
