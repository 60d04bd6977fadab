#include <algorithm>
#include <cmath>

#include "laboratory/arc.hpp"

namespace dashpad::laboratory {
namespace {

/// The rate, which at a vertex is exactly 0.
double rate_in(const StrainPiece& piece, double time) {
  const double rate = piece.rate_at(time);
  return std::abs(rate) < 1e-13 * std::abs(piece.acceleration * time) ? 0 : rate;
}

}  // namespace

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
    // The end is the start of the next piece, so that rounding opens no gap between them.
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

double duration_of(const StrainHistory& history) {
  double time = 0;
  for (const StrainPiece& piece : history.pieces) time += piece.duration;
  return time;
}

double end_of_first_loading(const StrainHistory& history) {
  double begin = 0, loaded_until = 0;
  for (const StrainPiece& piece : history.pieces) {
    const bool grows = piece.rate > 0 || (piece.rate == 0 && piece.acceleration > 0);
    if (!grows && loaded_until > 0) break;
    const double turn = piece.acceleration < 0 ? -piece.rate / piece.acceleration : piece.duration;
    if (grows) loaded_until = begin + std::min(turn, piece.duration);
    if (grows && turn < piece.duration) break;
    begin += piece.duration;
  }
  return loaded_until;
}

double strain_at(const StrainHistory& history, double time) {
  double begin = 0;
  for (const StrainPiece& piece : history.pieces) {
    if (time <= begin + piece.duration || &piece == &history.pieces.back())
      return piece.strain_at(std::min(time - begin, piece.duration));
    begin += piece.duration;
  }
  return 0;
}

StrainHistory split_at(const StrainHistory& history, const std::vector<double>& times) {
  const double shortest = 1e-12 * duration_of(history);
  StrainHistory split;
  double begin = 0;
  auto mark = times.begin();
  for (const StrainPiece& piece : history.pieces) {
    double done = 0;
    const auto add_until = [&](double end) {
      split.pieces.push_back({end - done, piece.strain_at(done), rate_in(piece, done), piece.acceleration});
      done = end;
    };
    for (; mark != times.end() && *mark - begin < piece.duration - shortest; ++mark)
      if (*mark - begin > done + shortest) add_until(*mark - begin);
    add_until(piece.duration);
    begin += piece.duration;
  }
  return split;
}

}  // namespace dashpad::laboratory
