#pragma once
/// How fast a pad of law 4 or 5 is pressed that is in balance with its support, and which way: theory.md,
/// Eqs. 26 and 45.

#include <cmath>

#include "oracle/pads.hpp"
#include "oracle/speed_root.hpp"

namespace dashpad::oracle {

/// All calls are for the pad as it was prepared last. `gain`: rate of the support's force while the pad is
/// held, N/s; `stiffness`: of the support, N/m.
class Pace {
 public:
  /// `impact_speed`: m/s.
  Pace(const PadModel& pad, double impact_speed) : pad_(pad), fastest_(std::log(100 * impact_speed)) {}
  [[nodiscard]] int way() const { return way_; }
  /// What the support's force gains on that of the pad, N/s, at a speed.
  [[nodiscard]] double surplus(double log_speed, int way, double gain, double stiffness) const {
    const double speed = log_speed <= log_of_no_speed ? 0 : way * std::exp(log_speed);
    return gain - stiffness * speed - pad_.force_rate(log_speed, way);
  }
  [[nodiscard]] double drive(double gain) const { return surplus(log_of_no_speed, +1, gain, 0); }

  /// dY/dt, m/s, at which none gains.
  [[nodiscard]] double balanced(double gain, double stiffness) {
    if (way_ > 0 && drive(gain) <= 0) return 0;
    // At speeds that no pad has, the formula of law 5 turns.
    const double log_speed = root_.find([&](double x) {
      return x > fastest_ ? 1e3 * std::fabs(gain) : -way_ * surplus(x, way_, gain, stiffness);
    });
    return log_speed <= log_of_no_speed ? 0 : way_ * std::exp(log_speed);
  }
  /// Loading, from about such a speed on.
  void load(double speed) {
    way_ = 1;
    root_.guess(std::log(speed));
  }
  /// From the fastest speed of coming back on, no faster than `most`; false where there is none.
  bool turn(double gain, double stiffness, double most) {
    double log_speed = std::log(most);
    const double last = log_speed - 60;
    while (log_speed > last && surplus(log_speed, -1, gain, stiffness) > 0) log_speed -= 0.1;
    if (log_speed <= last) return false;
    way_ = -1;
    root_.guess(log_speed + 0.05);
    return true;
  }
  void set_way(int way) { way_ = way; }

 private:
  const PadModel& pad_;
  double fastest_;
  SpeedRoot root_;
  int way_ = 1;
};

}  // namespace dashpad::oracle
