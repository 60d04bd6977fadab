#include "output/plot/line_places.hpp"

#include <cmath>
#include <cstddef>

namespace dashpad::output {

namespace {

double distance(const PlotPlace& a, const PlotPlace& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

double length_of(const PlaceLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

PlotPlace place_on(const PlaceLine& line, double length) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (step > 0 && length <= step)
      return {std::lerp(line[i - 1].x, line[i].x, length / step),
              std::lerp(line[i - 1].y, line[i].y, length / step)};
    length -= step;
  }
  return line.back();
}

}  // namespace dashpad::output
