#include "dashpad/injury/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "injury/hic_search.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

/// The clip of a pulse that is too short, or of a hump.
std::optional<Clip> simple_clip(const Pulse& pulse, double duration) {
  check(pulse);
  if (!(duration > 0)) throw std::invalid_argument("clip: the duration must be positive");
  if (attainable(pulse, duration) > pulse.time.back() - pulse.time.front()) return Clip{};
  if (const std::optional<Hump> hump = hump_of(pulse)) return clip_of(*hump, pulse, duration);
  return std::nullopt;
}

/// A window of fixed length that moves over the magnitude from corner to corner.
class Window {
 public:
  Window(const Magnitude& line, double length) : line_(line), length_(length), begin_(line.front().time) {
    while (last_ + 2 < line.size() && line[last_ + 1].time < begin_ + length) pass_at_end();
  }

  /// Moves until begin or end meets a corner, and offers the best window on the way. False at the end.
  bool advance(Clip& best) {
    const double at_end = line_[last_ + 1].time - length_;
    const double at_begin = line_[first_ + 1].time;
    const bool end_is_first = at_end <= at_begin;
    const double next = std::max(begin_, end_is_first ? at_end : at_begin);
    offer_between(next, best);
    begin_ = next;
    if (end_is_first) {
      if (last_ + 2 == line_.size()) return false;
      pass_at_end();
    } else {
      ++first_;
      if (!lowest_.empty() && lowest_.front() <= first_) lowest_.pop_front();
    }
    return true;
  }

 private:
  [[nodiscard]] double at(double time, std::size_t piece) const {
    const LinePoint& from = line_[piece];
    const LinePoint& to = line_[piece + 1];
    if (!(to.time > from.time)) return to.value;
    return std::lerp(from.value, to.value, std::clamp((time - from.time) / (to.time - from.time), 0.0, 1.0));
  }

  void offer(double level, double begin, Clip& best) const {
    if (!lowest_.empty()) level = std::min(level, line_[lowest_.front()].value);
    if (level > best.level) best = {level, begin, 0};
  }

  /// With both ends on straight pieces, the lower of the two is highest at a limit or where they are equal.
  void offer_between(double next, Clip& best) const {
    const double left = at(begin_, first_);
    const double right = at(begin_ + length_, last_);
    const double next_left = at(next, first_);
    const double next_right = at(next + length_, last_);
    offer(std::min(left, right), begin_, best);
    const double lead = left - right;
    const double next_lead = next_left - next_right;
    if ((lead < 0 && next_lead > 0) || (lead > 0 && next_lead < 0)) {
      const double share = lead / (lead - next_lead);
      offer(std::lerp(left, next_left, share), std::lerp(begin_, next, share), best);
    }
    offer(std::min(next_left, next_right), next, best);
  }

  void pass_at_end() {
    ++last_;
    while (!lowest_.empty() && line_[lowest_.back()].value >= line_[last_].value) lowest_.pop_back();
    lowest_.push_back(last_);
  }

  const Magnitude& line_;
  double length_;
  double begin_;
  std::size_t first_ = 0;           // piece with the begin
  std::size_t last_ = 0;            // piece with the end
  std::deque<std::size_t> lowest_;  // corners inside, each the lowest from there on
};

Magnitude checked(const Pulse& pulse, double level) {
  check(pulse);
  if (!(level >= 0)) throw std::invalid_argument("dwell: the level must not be negative");
  return magnitude_of(pulse);
}

}  // namespace

/// The result is the highest minimum over a window of that length.
Clip contiguous_clip(const Pulse& pulse, double duration) {
  if (const std::optional<Clip> clip = simple_clip(pulse, duration)) return *clip;
  const Magnitude line = magnitude_of(pulse);
  Clip best{-1, 0, 0};
  Window window(line, attainable(pulse, duration));
  while (window.advance(best)) {
  }
  best.end = std::min(best.begin + duration, pulse.time.back());
  return best;
}

/// The time at or above a level decreases with the level: linearly between neighbouring corner values, and
/// with a jump at a plateau. Bisection finds the two values.
Clip cumulative_clip(const Pulse& pulse, double duration) {
  if (const std::optional<Clip> clip = simple_clip(pulse, duration)) return *clip;
  const double wanted = attainable(pulse, duration);
  const Magnitude line = magnitude_of(pulse);
  const auto time_at = [&](double level) {
    double sum = 0;
    for_each_stretch(line, level, Bound::reached, [&](double begin, double end) { sum += end - begin; });
    return sum;
  };

  std::vector<double> levels(line.size());
  std::transform(line.begin(), line.end(), levels.begin(),
                 [](const LinePoint& corner) { return corner.value; });
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  const auto above =
      std::partition_point(levels.begin() + 1, levels.end(), [&](double x) { return time_at(x) >= wanted; });

  Clip clip;
  clip.level = *(above - 1);
  if (above != levels.end()) {
    double slope = 0;  // time lost for each unit of level, by the pieces that cross from one to the other
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto [low, high] = std::minmax(line[i - 1].value, line[i].value);
      if (low <= clip.level && high >= *above) slope += (line[i].time - line[i - 1].time) / (high - low);
    }
    const double missing = duration - time_at(*above);
    if (missing < slope * (*above - clip.level)) clip.level = *above - missing / slope;
  }
  bool first = true;
  for_each_stretch(line, clip.level, Bound::reached, [&](double begin, double end) {
    if (first) clip.begin = begin;
    first = false;
    clip.end = end;
  });
  return clip;
}

double cumulative_dwell(const Pulse& pulse, double level) {
  double sum = 0;
  for_each_stretch(checked(pulse, level), level, Bound::exceeded,
                   [&](double begin, double end) { sum += end - begin; });
  return sum;
}

double longest_dwell(const Pulse& pulse, double level) {
  double longest = 0;
  for_each_stretch(checked(pulse, level), level, Bound::exceeded,
                   [&](double begin, double end) { longest = std::max(longest, end - begin); });
  return longest;
}

}  // namespace dashpad::injury
