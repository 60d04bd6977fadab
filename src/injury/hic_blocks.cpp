#include "injury/hic_blocks.hpp"

#include <algorithm>

namespace dashpad::injury::hic_search {

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

std::size_t Blocks::last(std::size_t rank, std::size_t block) const {
  return std::min((block + 1) << rank, curve_->samples() - 1);
}

/// For a block with itself or the next one, where windows may be arbitrarily short: mean <= highest level.
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
