#pragma once
/// Batches computed on many threads and written by one: the part of a run that knows no physics.

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "dashpad/study/store.hpp"

namespace dashpad::study {

struct BatchWork {
  /// Into rows of a batch that is written, whose memory is used again.
  using Compute = std::function<void(std::uint64_t batch, std::vector<StoredRow>& rows)>;
  /// Called once a thread: what it returns serves that thread alone.
  std::function<Compute()> worker;
  /// Called for each batch in the order of the list, from one thread at a time.
  std::function<void(std::uint64_t batch, std::span<const StoredRow> rows)> write;
};

/// Computes and writes the batches on `threads`, 0: one a core, with a few batches per thread in memory. True
/// if all are written, false if `stop` came first. After an exception the batches before it in the list are
/// written.
bool run_batches(std::span<const std::uint64_t> batches, int threads, const std::atomic<bool>* stop,
                 const BatchWork& work);

}  // namespace dashpad::study
