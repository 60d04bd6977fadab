#pragma once
// The loop of TBB by threads of the standard library: Debian has no TBB for Windows.

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

/// 0 outside of loops and for their caller, which takes part.
inline thread_local unsigned worker_number = 0;
inline thread_local bool is_in_loop = false;

inline unsigned worker_count() { return std::max(1u, std::thread::hardware_concurrency()); }

/// The first exception of a turn ends the loop. A loop within a loop is serial.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  if (first >= last) return;
  const auto turns = last - first;
  const auto threads = turns < worker_count() ? static_cast<unsigned>(turns) : worker_count();
  if (is_in_loop || threads == 1) {
    for (Index i = first; i < last; ++i) body(i);
    return;
  }
  std::atomic<Index> next{first};
  std::exception_ptr failure;
  std::mutex of_failure;
  const auto work = [&](unsigned number) {
    worker_number = number;
    is_in_loop = true;
    try {
      for (Index i = next++; i < last; i = next++) body(i);
    } catch (...) {
      next = last;
      const std::lock_guard lock{of_failure};
      if (!failure) failure = std::current_exception();
    }
    is_in_loop = false;
  };
  {
    std::vector<std::jthread> others;
    for (unsigned number = 1; number < threads; ++number) others.emplace_back(work, number);
    work(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tbb

namespace oneapi {
namespace tbb = ::tbb;
}
