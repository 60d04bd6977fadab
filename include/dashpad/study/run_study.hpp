#pragma once
/// Runs what is missing of a study, on all cores of this machine, or on all ranks of an MPI job.

#include <atomic>
#include <cstdint>
#include <functional>

#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

struct Progress {
  std::uint64_t rows_done = 0, rows = 0;
  double seconds = 0;             ///< since this run began
  std::uint64_t rows_before = 0;  ///< done by earlier runs
};

struct RunSettings {
  int threads = 0;                                     ///< 0: all cores
  const std::atomic<bool>* stop = nullptr;             ///< set to finish the batches at hand and return
  std::function<void(const Progress&)> progress = {};  ///< from one thread at a time
};

/// True where all rows are there at the end, false where it was stopped. What goes wrong in writing is thrown
/// after the batches at hand: std::runtime_error.
bool run(const Study& study, Store& store, const RunSettings& settings = {});

}  // namespace dashpad::study
