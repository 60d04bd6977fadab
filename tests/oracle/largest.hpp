#pragma once

#include <array>
#include <cmath>

namespace dashpad::oracle {

/// The largest value of a function that is known at moments: where it is smooth, the vertex of the last
/// three.
class Largest {
 public:
  void add(double time, double value) {
    if (known_ > 0 && time <= time_[2]) return;
    time_ = {time_[1], time_[2], time}, value_ = {value_[1], value_[2], value};
    known_ = known_ < 3 ? known_ + 1 : 3;
    most_ = std::fmax(most_, value);
    if (known_ < 3 || !(value_[1] >= value_[0] && value_[1] >= value_[2])) return;
    const double a = time_[0] - time_[1], b = time_[2] - time_[1];
    const double by_a = (value_[0] - value_[1]) / a, by_b = (value_[2] - value_[1]) / b;
    const double curve = (by_b - by_a) / (b - a), rise = by_a - curve * a;
    const double above = -rise * rise / (4 * curve);
    if (curve < 0 && above < 1e-3 * value_[1]) most_ = std::fmax(most_, value_[1] + above);
  }
  /// After a jump of its slope.
  void start_anew() { known_ = 0; }
  [[nodiscard]] double most() const { return most_; }

 private:
  std::array<double, 3> time_{}, value_{};
  int known_ = 0;
  double most_ = 0;
};

}  // namespace dashpad::oracle
