#include "oracle/contact_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dashpad::oracle {

std::vector<ContactPoint> contact_points(const Outline& nose, double y, double gap, int fineness) {
  // Five points of Gauss on [0, 1].
  constexpr std::array<double, 5> place{0.0469100770306680, 0.2307653449471585, 0.5, 0.7692346550528415,
                                        0.9530899229693320};
  constexpr std::array<double, 5> weight{0.1184634425280945, 0.2393143352496832, 0.2844444444444444,
                                         0.2393143352496832, 0.1184634425280945};
  std::vector<ContactPoint> all;
  if (!(y > 0)) return all;
  if (nose.tip > 0) all.push_back({0, y, nose.tip});
  const double last = std::fmin(y, nose.end);
  if (last == 0) return all;
  // Ends of panels below the middle by the distance from the axis, above it by that from the edge.
  std::vector<double> low{0, y / 2}, high{y / 2, 0};
  const double ratio = std::pow(2.0, 1.0 / fineness);
  for (double s = y / 2 / ratio; s > std::fmax(std::fmin(1e-4 * y, gap / 2), 1e-10 * y); s /= ratio)
    low.push_back(s);
  for (double a = y / 2 / ratio; a > 1e-4 * y; a /= ratio) high.push_back(a);
  for (const double corner : nose.corners)
    if (0 < corner && corner < last)
      (corner < y / 2 ? low : high).push_back(corner < y / 2 ? corner : y - corner);
  if (last < y / 2) low.push_back(last);
  if (y / 2 < last && last < y) high.push_back(y - last);
  std::ranges::sort(low), std::ranges::sort(high);
  const auto add = [&](double depth, double above, double span) {
    all.push_back({depth, above, nose.widening(depth) * span});
  };
  for (std::size_t i = 1; i < low.size() && low[i] <= last; ++i) {
    const double span = low[i] - low[i - 1];
    for (std::size_t k = 0; k < place.size() && span > 0; ++k) {
      // The first in the root of the depth: also where the widening has no bound at the tip.
      const double x = place[k], s = i == 1 ? span * x * x : low[i - 1] + span * x;
      add(s, y - s, span * weight[k] * (i == 1 ? 2 * x : 1));
    }
  }
  for (std::size_t i = 1; i < high.size(); ++i) {
    const double span = high[i] - high[i - 1];
    if (!(span > 0) || y - high[i - 1] > last + 1e-12 * y) continue;
    for (std::size_t k = 0; k < place.size(); ++k) {
      const double x = place[k], a = i == 1 ? span * std::pow(x, 4) : high[i - 1] + span * x;
      add(y - a, a, span * weight[k] * (i == 1 ? 4 * std::pow(x, 3) : 1));
    }
  }
  return all;
}

}  // namespace dashpad::oracle
