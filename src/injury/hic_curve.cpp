#include "injury/hic_curve.hpp"

namespace dashpad::injury::hic_search {

void Curve::assign(const Pulse& pulse, double factor) {
  time_ = &pulse.time;
  level_.resize(samples());
  velocity_.resize(samples());
  for (std::size_t i = 0; i < samples(); ++i) level_[i] = factor * pulse.acceleration[i];
  AccurateSum sum;
  velocity_[0] = {0, 0};
  for (std::size_t i = 0; i + 1 < samples(); ++i) {
    sum.add(length(i) * (level_[i] + level_[i + 1]) / 2);
    velocity_[i + 1] = {sum.high(), sum.low()};
  }
}

double Curve::gain(const Window& window) const {
  double sum = gained(window.first, window.last);
  if (window.before > 0)
    sum += window.before * (level_[window.first] - slope(window.first - 1) * window.before / 2);
  if (window.after > 0) sum += window.after * (level_[window.last] + slope(window.last) * window.after / 2);
  return sum;
}

}  // namespace dashpad::injury::hic_search
