#include "dashpad/injury/metrics.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "injury/hic_search.hpp"
#include "injury/hump.hpp"

namespace dashpad::injury {
namespace {

using hic_search::Best;
using hic_search::Blocks;
using hic_search::Curve;

/// The windows of the greatest length, earliest first: a start that lets most pairs of blocks be left out.
void offer_all_longest(const Curve& curve, double longest, Best& best) {
  const std::size_t intervals = curve.samples() - 1;
  std::size_t j = 0;
  for (std::size_t i = 0; i < intervals; ++i) {
    // The first interval in which a window from interval i can end.
    j = std::max(i, j);
    while (j < intervals && curve.elapsed(i, j + 1) < longest) ++j;
    for (std::size_t k = j; k < intervals && (k <= i || curve.elapsed(i + 1, k) <= longest); ++k)
      offer_longest(curve, i, k, longest, best);
  }
}

/// Branch and bound over pairs of blocks: the windows that begin in the one and end in the other.
class Search {
 public:
  Search(const Curve& curve, double longest, Best& best)
      : curve_(curve), blocks_(curve), longest_(longest), best_(best) {}

  void run() { visit(blocks_.top(), 0, 0); }

 private:
  struct Pair {
    double bound = 0;
    std::size_t i = 0, j = 0;
  };

  void visit(std::size_t rank, std::size_t i, std::size_t j) {
    // Any window of the pair: the sooner a good one is known, the more pairs can be left out.
    const hic_search::Window window{blocks_.last(rank, i),
                                    std::max(blocks_.last(rank, i), Blocks::first(rank, j)), 0, 0};
    if (curve_.duration(window) <= longest_) best_.offer(curve_, window);
    if (rank == 0) {
      offer_candidates(curve_, i, j, longest_, best_);
      return;
    }
    --rank;
    std::array<Pair, 4> pairs;
    auto next = pairs.begin();
    const std::size_t count = blocks_.count(rank);
    for (std::size_t k = 2 * i; k < std::min(2 * i + 2, count); ++k)
      for (std::size_t l = std::max(k, 2 * j); l < std::min(2 * j + 2, count); ++l)
        *next++ = {blocks_.bound(rank, k, l, longest_), k, l};
    // Where the best window is likely, first.
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.bound > b.bound; });
    for (const Pair& pair : pairs)
      if (pair.bound > 0 && !best_.rules_out(pair.bound, curve_.time(Blocks::first(rank, pair.i))))
        visit(rank, pair.i, pair.j);
  }

  const Curve& curve_;
  const Blocks blocks_;
  const double longest_;
  Best& best_;
};

}  // namespace

Hic hic(const Pulse& pulse, double longest_window) {
  check(pulse);
  if (!(longest_window > 0)) throw std::invalid_argument("HIC: the longest window must be positive");
  const auto [lowest, highest] = std::minmax_element(pulse.acceleration.begin(), pulse.acceleration.end());
  const double largest = std::max(*highest, -*lowest);
  // Nor have denormal numbers a power 2.5 that is more.
  if (largest < std::numeric_limits<double>::min()) return {0, pulse.time.front(), pulse.time.front()};
  const double scale = scale_for(largest);
  if (const std::optional<Hump> hump = hump_of(pulse))
    return hic_of(*hump, Curve(pulse, hump->sign * scale), scale, longest_window);
  Best best;
  for (const double sign : {1.0, -1.0}) {
    if (!(std::max(sign * *highest, sign * *lowest) > 0)) continue;
    const Curve curve(pulse, sign * scale);
    if (longest_window < unlimited_window) offer_all_longest(curve, longest_window, best);
    Search(curve, longest_window, best).run();
  }
  return {hic_from(best.value(), scale), best.begin(), best.end()};
}

double hic_d(double hic36) { return 0.75446 * hic36 + 166.4; }

}  // namespace dashpad::injury
