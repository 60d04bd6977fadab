#include "front.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::bench {

std::vector<WorkPoint> front_of(const std::vector<WorkPoint>& points) {
  std::vector<WorkPoint> sorted = points, front;
  std::sort(sorted.begin(), sorted.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return a.time != b.time ? a.time < b.time : a.error < b.error;
  });
  for (const WorkPoint& point : sorted)
    if (front.empty() || point.error < front.back().error) front.push_back(point);
  std::reverse(front.begin(), front.end());
  return front;
}

FrontTime time_on(const std::vector<WorkPoint>& front, double error) {
  if (error < front.front().error) return {front.front().time, '>'};
  if (error > front.back().error) return {front.back().time, '<'};
  for (std::size_t i = 1; i < front.size(); ++i) {
    const WorkPoint &fine = front[i - 1], &coarse = front[i];
    if (error > coarse.error) continue;
    const double share = std::log(error / fine.error) / std::log(coarse.error / fine.error);
    return {fine.time * std::pow(coarse.time / fine.time, share), '='};
  }
  return {front.back().time, '='};
}

}  // namespace dashpad::bench
