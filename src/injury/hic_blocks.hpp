#pragma once
/// Blocks of intervals in a hierarchy, and what the windows between two blocks cannot exceed.

#include <cstddef>
#include <vector>

#include "injury/hic_curve.hpp"

namespace dashpad::injury::hic_search {

/// Block k of rank r holds the intervals from k 2^r on, 2^r of them or what is left.
class Blocks {
 public:
  explicit Blocks(const Curve& curve);

  /// The lowest rank whose block 0 holds everything.
  [[nodiscard]] std::size_t top() const { return bounds_.size() - 1; }
  [[nodiscard]] std::size_t count(std::size_t rank) const { return bounds_[rank].size(); }

  /// No window that begins in block i, ends in block j >= i of the same rank and is not longer than `longest`
  /// has a larger criterion.
  [[nodiscard]] double bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const;

  /// The first sample of a block, and the last.
  [[nodiscard]] static std::size_t first(std::size_t rank, std::size_t block) { return block << rank; }
  [[nodiscard]] std::size_t last(std::size_t rank, std::size_t block) const;

 private:
  /// Within a block: how far the velocity is below and above the straight line between its ends, and the
  /// highest level.
  struct Bounds {
    double below, above, level;
  };
  [[nodiscard]] double close_bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const;

  const Curve* curve_;
  std::vector<std::vector<Bounds>> bounds_;  // [rank][block]
};

}  // namespace dashpad::injury::hic_search
