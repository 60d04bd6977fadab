#pragma once
/// Hands out the batches of a study to ranks, computes some itself, and writes all results.

#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "dashpad/study/batch.hpp"
#include "dashpad/study/run_study.hpp"
#include "mpi/ranks.hpp"

namespace dashpad::app {

/// What rank 0 does. One thread computes; the other one serves, writes and sleeps in between, so that a core
/// is enough for both.
class StudyScheduler {
 public:
  StudyScheduler(const study::Study& study, study::Store& store, int other_ranks);

  /// Until every rank is told to stop. True where all rows are there. Throws what went wrong in a rank or in
  /// writing, after the batches at hand.
  bool serve(const std::function<void(const study::Progress&)>& progress);

 private:
  std::optional<std::uint64_t> next_batch();
  void close();
  void compute();
  void answer(const Letter& letter);
  void write(const BatchReport& report);
  std::optional<BatchReport> own_report();
  void fail(std::exception_ptr failure);

  const study::Study& study_;
  study::Store& store_;
  study::Design design_;
  int open_ranks_ = 0;
  std::uint64_t rows_done_ = 0;

  std::mutex mutex_;  ///< of what follows
  std::deque<std::uint64_t> batches_;
  std::deque<BatchReport> own_;
  bool computing_ = true;
  std::exception_ptr failure_;
};

}  // namespace dashpad::app
