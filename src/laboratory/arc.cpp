#include "laboratory/arc.hpp"

#include <algorithm>

namespace dashpad::laboratory {

Motion Stretch::after_start(double x) const {
  return {std::max(start.strain + x * (start.rate + x * acceleration / 2), 0.0),
          start.rate + x * acceleration};
}

Motion Stretch::before_end(double y) const {
  return {std::max(end.strain - y * (end.rate - y * acceleration / 2), 0.0), end.rate - y * acceleration};
}

Stretch Stretch::part(double from, double to) const {
  return {time + from, to - from, from == 0 ? start : at(from), to == duration ? end : at(to), acceleration};
}

int Stretch::direction() const {
  const double twice_mean = start.rate + end.rate;
  return twice_mean > 0 ? 1 : twice_mean < 0 ? -1 : 0;
}

std::vector<Arc> arcs_of(const StrainHistory& history) {
  std::vector<Arc> arcs;
  double time = 0;
  for (std::size_t i = 0; i < history.pieces.size(); ++i) {
    const StrainPiece& piece = history.pieces[i];
    const bool last = i + 1 == history.pieces.size();
    // What the next piece begins with counts, so that no rounding opens a gap between the two.
    const Motion start{std::max(piece.strain, 0.0), piece.rate};
    const double reached = last ? piece.strain_at(piece.duration) : history.pieces[i + 1].strain;
    const Motion end{reached < 1e-15 ? 0 : reached, piece.rate_at(piece.duration)};
    const double vertex = piece.acceleration == 0 ? -1 : -piece.rate / piece.acceleration;
    if (vertex > 0 && vertex < piece.duration) {
      const Motion turn{start.strain + piece.rate * vertex / 2, 0};
      arcs.push_back({{time, vertex, start, turn, piece.acceleration}, piece.duration, 0});
      arcs.push_back(
          {{time + vertex, piece.duration - vertex, turn, end, piece.acceleration}, piece.duration, vertex});
    } else {
      arcs.push_back({{time, piece.duration, start, end, piece.acceleration}, piece.duration, 0});
    }
    time += piece.duration;
  }
  return arcs;
}

}  // namespace dashpad::laboratory
