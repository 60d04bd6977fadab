#include <algorithm>
#include <cmath>

#include "dashpad/quantities/constants.hpp"
#include "injury/hic_search.hpp"

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

namespace {

/// One end of a window, on an interval where the level falls from `high` to `low` as the window grows, or
/// fixed at the beginning or the end of the pulse.
struct End {
  double low = -infinite, high = infinite;
  double spread = 0;  // by how much the window grows as the level falls by 1, s
};

constexpr End fixed;

End begin_of(const Curve& curve, std::size_t i) {
  return {curve.level(i), curve.level(i + 1), 1 / curve.slope(i)};
}
End end_of(const Curve& curve, std::size_t j) {
  return {curve.level(j + 1), curve.level(j), -1 / curve.slope(j)};
}

/// Offers the window with c = 0.6 mean, among those from `first` to `last` whose ends are moved outwards to a
/// common level c. With c = base + d and the window at `base`, this condition is
///   0.7 spread d^2 - (duration - 0.4 spread base) d + 0.6 gain - base duration = 0,
/// and the maximum is at its lower root.
void offer_stationary(const Curve& curve, std::size_t first, const End& begin, std::size_t last,
                      const End& end, double longest, Best& best) {
  const double base = std::max(begin.low, end.low);
  const double top = std::min(begin.high, end.high);
  const double spread = begin.spread + end.spread;
  if (!(spread > 0) || !(base <= top) || !(spread < infinite)) return;
  const auto window_at = [&](double level) {
    const auto moved = [&](const End& side) {
      return side.spread > 0
                 ? std::clamp((side.high - level) * side.spread, 0.0, (side.high - side.low) * side.spread)
                 : 0;
    };
    return Window{first, last, moved(begin), moved(end)};
  };
  const Window widest = window_at(base);
  const double duration = curve.duration(widest);
  const double constant = 0.6 * curve.gain(widest) - base * duration;
  const double falling = duration - 0.4 * spread * base;
  const double discriminant = falling * falling - 2.8 * spread * constant;
  // A root that rounding moves out of the range is taken at its end; an unneeded window does no harm.
  double d = 0;
  if (constant > 0)
    d = falling > 0 && discriminant >= 0 ? 2 * constant / (falling + std::sqrt(discriminant)) : infinite;
  const Window window = window_at(std::min(base + d, top));
  if (curve.duration(window) <= longest) best.offer(curve, window);
}

}  // namespace

void Best::offer(const Curve& curve, const Window& window) {
  const double duration = curve.duration(window);
  const double value = criterion(duration, curve.gain(window));
  if (!(value > 0) || value < highest_ * (1 - rounding)) return;
  highest_ = std::max(highest_, value);
  const double begin = std::max(curve.time(window.first) - window.before, curve.time(0));
  // Windows that begin at almost the same time are the same window, with different rounding.
  const double earlier = begin_ - begin;
  const bool same = std::abs(earlier) <= 1e-6 * duration;
  if (value > value_ * (1 + rounding) || (same ? value > value_ : earlier > 0)) {
    value_ = value;
    begin_ = begin;
    end_ = std::min(curve.time(window.last) + window.after, curve.time(curve.samples() - 1));
  }
}

void offer_longest(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best) {
  if (i == j) {
    // Within one line the mean is highest at one of its ends.
    if (longest > curve.length(i)) return;
    best.offer(curve, {i, i, 0, longest});
    best.offer(curve, {i + 1, i + 1, longest, 0});
    return;
  }
  const double rest = longest - curve.elapsed(i + 1, j);  // before + after
  const double least = std::max(0.0, rest - curve.length(j));
  const double most = std::min(curve.length(i), rest);
  if (!(least <= most)) return;
  const auto offer = [&](double before) { best.offer(curve, {i + 1, j, before, rest - before}); };
  // The level at the beginning minus that at the end is the rate of gain of an earlier window.
  const double difference = curve.level(i + 1) - curve.level(j) - curve.slope(j) * rest;
  const double bend = curve.slope(i) - curve.slope(j);
  if (bend > 0) {
    offer(std::clamp(difference / bend, least, most));
  } else {
    offer(most);
    offer(least);
  }
}

void offer_candidates(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best) {
  const std::size_t final_sample = curve.samples() - 1;
  const bool rises = curve.level(i + 1) > curve.level(i);
  const bool falls = curve.level(j + 1) < curve.level(j);
  const bool from_start = i == 0;
  const bool to_end = j + 1 == final_sample;
  if (from_start && to_end && curve.elapsed(0, final_sample) <= longest)
    best.offer(curve, {0, final_sample, 0, 0});
  if (from_start && falls) offer_stationary(curve, 0, fixed, j, end_of(curve, j), longest, best);
  if (rises && falls && i < j)
    offer_stationary(curve, i + 1, begin_of(curve, i), j, end_of(curve, j), longest, best);
  if (to_end && rises) offer_stationary(curve, i + 1, begin_of(curve, i), final_sample, fixed, longest, best);
  if (longest < infinite) offer_longest(curve, i, j, longest, best);
}

Blocks::Blocks(const Curve& curve) : curve_(&curve) {
  const std::size_t intervals = curve.samples() - 1;
  auto& finest = bounds_.emplace_back();
  finest.reserve(intervals);
  for (std::size_t i = 0; i < intervals; ++i) {
    const double sag = (curve.level(i + 1) - curve.level(i)) * curve.length(i) / 8;
    finest.push_back({std::max(sag, 0.0), std::max(-sag, 0.0), std::max(curve.level(i), curve.level(i + 1))});
  }
  while (bounds_.back().size() > 1) {
    const std::size_t rank = bounds_.size();
    const std::size_t parts = bounds_.back().size();
    auto& merged = bounds_.emplace_back();
    merged.reserve((parts + 1) / 2);
    const auto& part = bounds_[rank - 1];
    for (std::size_t k = 0; k < parts; k += 2) {
      if (k + 1 == parts) {
        merged.push_back(part[k]);
        continue;
      }
      const std::size_t begin = first(rank - 1, k);
      const std::size_t middle = first(rank - 1, k + 1);
      const std::size_t end = last(rank - 1, k + 1);
      const double share = curve.elapsed(begin, middle) / curve.elapsed(begin, end);
      const double rise = curve.gained(begin, middle) * (1 - share) - curve.gained(middle, end) * share;
      merged.push_back({std::max(part[k].below, part[k + 1].below) + std::max(-rise, 0.0),
                        std::max(part[k].above, part[k + 1].above) + std::max(rise, 0.0),
                        std::max(part[k].level, part[k + 1].level)});
    }
  }
}

/// For adjacent or equal blocks, with arbitrarily short windows: the mean is at most the highest level.
double Blocks::close_bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const {
  const Bounds& begin = bounds_[rank][i];
  const Bounds& end = bounds_[rank][j];
  const double level = std::max(begin.level, end.level);
  if (level <= 0) return 0;
  const double duration = std::min(longest, curve_->elapsed(first(rank, i), last(rank, j)));
  const auto climb = [&](std::size_t block) {
    return std::abs(curve_->gained(first(rank, block), last(rank, block)));
  };
  const double gain =
      i == j ? climb(i) + begin.above + begin.below : climb(i) + climb(j) + begin.below + end.above;
  return level * std::sqrt(level) * std::min(level * duration, gain);
}

/// The criterion is convex in (duration, gain) and grows with the gain. So over the begins on the line below
/// the one block and the ends on the line above the other it is largest at a corner of
/// 0 <= before <= length of i, 0 <= after <= length of j, before + after <= rest.
double Blocks::bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const {
  if (j <= i + 1) return close_bound(rank, i, j, longest);
  const std::size_t from = last(rank, i);
  const std::size_t to = first(rank, j);
  const double gap = curve_->elapsed(from, to);
  const double rest = longest - gap;
  if (rest <= 0) return 0;
  const double before = curve_->elapsed(first(rank, i), from);
  const double after = curve_->elapsed(to, last(rank, j));
  const double before_level = curve_->gained(first(rank, i), from) / before;
  const double after_level = curve_->gained(to, last(rank, j)) / after;
  const double gain = curve_->gained(from, to) + bounds_[rank][i].below + bounds_[rank][j].above;
  const auto corner = [&](double b, double a) {
    return criterion(gap + b + a, gain + before_level * b + after_level * a);
  };
  const double b = std::min(before, rest);
  const double a = std::min(after, rest);
  const double nearer = std::max({corner(0, 0), corner(b, 0), corner(0, a)});
  if (before + after <= rest) return std::max(nearer, corner(before, after));
  return std::max({nearer, corner(b, rest - b), corner(rest - a, a)});
}

}  // namespace dashpad::injury::hic_search
