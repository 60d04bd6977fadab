#pragma once
/// The windows that can be the best of all windows that begin in one interval and end in another, and the
/// best of those that were offered. Why these windows suffice: docs/injury.md, HIC.

#include "injury/hic_curve.hpp"

namespace dashpad::injury::hic_search {

/// Two values that differ by less, relative, count as the same.
inline constexpr double rounding = 1e-13;

/// The best window so far, and of windows with the same value the earliest.
class Best {
 public:
  void offer(const Curve& curve, const Window& window);

  /// Whether no window that begins at `begin` (s) or later, and whose value is at most `bound`, is wanted.
  [[nodiscard]] bool rules_out(double bound, double begin) const {
    return bound <= highest_ * (1 + (begin < begin_ ? -2 : 1) * rounding);
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double end() const { return end_; }

 private:
  double highest_ = 0;
  double value_ = 0, begin_ = 0, end_ = 0;
};

/// Offers the best of the windows of length `longest` that begin in interval i and end in interval j >= i.
void offer_longest(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best);

/// Offers every window not longer than `longest` that begins in interval i, ends in interval j >= i and can
/// be the best of all.
void offer_candidates(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best);

}  // namespace dashpad::injury::hic_search
