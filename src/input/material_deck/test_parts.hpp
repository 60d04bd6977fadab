#pragma once
/// What the points of a compression test belong to: the first loading, the way back, holds, cycles.

#include <cstddef>
#include <optional>
#include <vector>

#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// Points at a constant strain while the stress relaxes.
struct Hold {
  std::size_t first = 0, last = 0;  ///< index of its points; the first belongs to the loading
  double lost = 0;                  ///< share of the stress
};

/// The points by their index.
struct TestParts {
  std::vector<std::size_t> loading, back;  ///< back: from the largest strain down
  std::size_t top = 0;                     ///< where the loading ends, at its largest strain but for noise
  std::size_t noisy = 0;               ///< points of the loading below the largest strain before, by noise
  std::optional<std::size_t> cycle;    ///< where the strain first turns back and comes back
  std::vector<Hold> holds;             ///< on the loading
  std::optional<std::size_t> outlier;  ///< a single strain far from both beside it
};

TestParts parts_of(const DeckCurve& test);

}  // namespace dashpad::input
