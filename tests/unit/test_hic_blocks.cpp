/// The bounds behind the search for the HIC: no window is better than the bound of its pair of blocks, and
/// the bounds are tight enough to be of use.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "injury/hic_search.hpp"

namespace dashpad::injury::hic_search {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

TEST(HicBlocks, HoldAllIntervals) {
  for (const std::size_t samples : {2U, 3U, 4U, 5U, 6U, 9U, 10U, 1000U}) {
    Pulse pulse;
    for (std::size_t i = 0; i < samples; ++i) {
      pulse.time.push_back(static_cast<double>(i));
      pulse.acceleration.push_back(1);
    }
    const Curve curve(pulse, 1);
    const Blocks blocks(curve);
    ASSERT_EQ(blocks.count(blocks.top()), 1U);
    for (std::size_t rank = 0; rank <= blocks.top(); ++rank) {
      std::size_t next = 0;
      for (std::size_t k = 0; k < blocks.count(rank); ++k) {
        ASSERT_EQ(Blocks::first(rank, k), next);
        next = blocks.last(rank, k);
        ASSERT_LT(Blocks::first(rank, k), next);
      }
      ASSERT_EQ(next, samples - 1);
    }
  }
}

/// Sampled windows of every pair of blocks, not longer than the limit; in half of them just as long.
TEST(HicBlocks, AreNotExceeded) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 300; ++trial) {
    Pulse pulse;
    const std::size_t samples = std::uniform_int_distribution<std::size_t>(2, 40)(random);
    double t = 0;
    double a = 0;
    const double pull = unit(random);
    for (std::size_t i = 0; i < samples; ++i) {
      pulse.time.push_back(t += std::pow(10, -2 * unit(random)));
      pulse.acceleration.push_back(a = (1 - pull) * a + unit(random) - 0.4);
    }
    const Curve curve(pulse, 1);
    const Blocks blocks(curve);
    const double longest = trial % 3 == 0 ? forever : (t - pulse.time[0]) * unit(random);
    for (std::size_t rank = 0; rank <= blocks.top(); ++rank)
      for (std::size_t i = 0; i < blocks.count(rank); ++i)
        for (std::size_t j = i; j < blocks.count(rank); ++j)
          for (int n = 0; n < 20; ++n) {
            // A window from sample k or before to sample l or after.
            const auto within = [&](std::size_t block) {
              return std::uniform_int_distribution(Blocks::first(rank, block),
                                                   blocks.last(rank, block))(random);
            };
            const std::size_t k = within(i);
            const std::size_t l = within(j);
            if (k > l) continue;
            Window window{k, l, 0, 0};
            if (k > Blocks::first(rank, i)) window.before = unit(random) * curve.length(k - 1);
            if (l < blocks.last(rank, j)) window.after = unit(random) * curve.length(l);
            if (n % 2 == 0 && window.after > 0)
              window.after = std::clamp(longest - curve.elapsed(k, l) - window.before, 0.0, curve.length(l));
            const double duration = curve.duration(window);
            if (duration > longest) continue;
            ASSERT_LE(criterion(duration, curve.gain(window)),
                      blocks.bound(rank, i, j, longest) * (1 + 1e-13) + 1e-13)
                << "rank " << rank << ", blocks " << i << " and " << j << ", longest " << longest;
          }
  }
}

/// For a smooth pulse a bound is above the best window of its blocks by the square of their length.
TEST(HicBlocks, CloseInAtOrderTwo) {
  Pulse pulse;
  constexpr std::size_t intervals = 4096;
  for (std::size_t i = 0; i <= intervals; ++i) {
    pulse.time.push_back(static_cast<double>(i) / intervals);
    pulse.acceleration.push_back(std::sin(std::numbers::pi * pulse.time.back()));
  }
  const Curve curve(pulse, 1);
  const Blocks blocks(curve);
  const auto excess = [&](std::size_t rank) {
    double highest = 0;
    for (std::size_t i = 0; i < blocks.count(rank); ++i)
      for (std::size_t j = i; j < blocks.count(rank); ++j)
        highest = std::max(highest, blocks.bound(rank, i, j, forever));
    return highest - 0.4146455;  // less the best window of all
  };
  EXPECT_LT(excess(7), 2e-3);
  EXPECT_LT(excess(3), excess(7) / 100);  // blocks of a sixteenth
  EXPECT_GT(excess(3), 0);
}

}  // namespace
}  // namespace dashpad::injury::hic_search
