#pragma once
/// The head injury criterion of an oracle's own track: what an accelerometer in the impactor shows, by the
/// speed that it has lost, which between two steps is a cubic with the accelerations there as slopes.

#include <algorithm>
#include <cmath>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad::oracle {

class PulseTrack {
 public:
  /// `lost`: integral of the acceleration so far, m/s; `acceleration` in m/s2, positive while the pad pushes.
  void add(double time, double lost, double acceleration) { all_.push_back({time, lost, acceleration}); }

  /// max (t2 - t1) (mean acceleration in g)^2.5 over windows of at most so many seconds.
  [[nodiscard]] double hic(double longest) const {
    const std::vector<Instant> points = finer();
    double most = 0;
    const auto window = [&most](double span, double lost) {
      const double mean = std::fmax(lost, 0) / (span * standard_gravity);
      most = std::fmax(most, span * mean * mean * std::sqrt(mean));
    };
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        const double span = points[j].time - points[i].time, lost = points[j].lost - points[i].lost;
        if (span > longest) {  // the longest window ends between two points
          const double step = points[j].time - points[j - 1].time;
          window(longest, lost - (span - longest) / step * (points[j].lost - points[j - 1].lost));
          break;
        }
        window(span, lost);
      }
    return most;
  }

 private:
  struct Instant {
    double time = 0, lost = 0, acceleration = 0;
  };

  [[nodiscard]] std::vector<Instant> finer() const {
    constexpr std::size_t wanted = 4000;
    std::vector<Instant> points;
    const double step = all_.back().time / wanted;
    for (std::size_t i = 1; i < all_.size(); ++i) {
      const Instant &a = all_[i - 1], &b = all_[i];
      const double span = b.time - a.time;
      if (!(span > 0)) continue;
      const int parts = 1 + static_cast<int>(span / step);
      for (int k = 1; k <= parts; ++k) {
        const double u = double(k) / parts, w = 1 - u, time = a.time + u * span;
        points.push_back({time,
                          w * w * (1 + 2 * u) * a.lost + u * u * (1 + 2 * w) * b.lost +
                              u * w * span * (w * a.acceleration - u * b.acceleration),
                          0});
      }
    }
    return points;
  }

  std::vector<Instant> all_;
};

}  // namespace dashpad::oracle
