#include "laboratory/strain_marks.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::laboratory {

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

namespace {

/// At a vertex the rate is zero, not what rounding leaves of it.
double rate_in(const StrainPiece& piece, double time) {
  const double rate = piece.rate_at(time);
  return std::abs(rate) < 1e-13 * std::abs(piece.acceleration * time) ? 0 : rate;
}

}  // namespace

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
