#pragma once
/// A run with twice the step of a history that is made up.

#include "dashpad/impact/solution.hpp"

namespace dashpad::test {

/// Every second entry, both ends kept.
inline void add_coarser_run(Solution& solution) {
  const History& history = solution.history;
  solution.coarser = {};
  for (std::size_t i = 0; i < history.time.size(); i += i + 2 == history.time.size() ? 1 : 2) {
    solution.coarser.time.push_back(history.time[i]);
    solution.coarser.acceleration.push_back(history.acceleration[i]);
  }
}

}  // namespace dashpad::test
