#include "dashpad/study/run_study.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include <oneapi/tbb/concurrent_queue.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include "study/run_batches.hpp"

namespace dashpad::study {

namespace tbb = oneapi::tbb;

namespace {

struct Computed {
  std::uint64_t batch = 0;
  std::vector<StoredRow> rows;
};

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

bool run_batches(std::span<const std::uint64_t> batches, int threads, const std::atomic<bool>* stop,
                 const BatchWork& work) {
  constexpr std::size_t batches_a_thread = 4;
  const auto workers = static_cast<std::size_t>(threads > 0 ? threads : cores());
  // Allows more threads than cores if the user asks for them.
  const tbb::global_control allowed{tbb::global_control::max_allowed_parallelism, workers};
  tbb::enumerable_thread_specific<BatchWork::Compute> compute{[&work] { return work.worker(); }};

  // The pipeline forgets items in flight when a filter throws: they are owned here.
  std::vector<Computed> in_flight(batches_a_thread * workers);
  tbb::concurrent_queue<Computed*> unused;
  for (Computed& computed : in_flight) unused.push(&computed);
  std::size_t begun = 0;
  const auto next = tbb::make_filter<void, std::uint64_t>(
      tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) -> std::uint64_t {
        if (begun == batches.size() || (stop != nullptr && stop->load())) {
          control.stop();
          return 0;
        }
        return batches[begun++];
      });
  const auto compute_rows =
      tbb::make_filter<std::uint64_t, Computed*>(tbb::filter_mode::parallel, [&](std::uint64_t batch) {
        Computed* result = nullptr;
        unused.try_pop(result);  // there are as many as the pipeline has under way at most
        result->batch = batch;
        compute.local()(batch, result->rows);
        return result;
      });
  // Writing in order is fastest and gives the same bytes for any number of threads.
  const auto write =
      tbb::make_filter<Computed*, void>(tbb::filter_mode::serial_in_order, [&](Computed* done) {
        work.write(done->batch, done->rows);
        unused.push(done);
      });

  tbb::task_arena arena{threads};
  arena.execute([&] { tbb::parallel_pipeline(in_flight.size(), next & compute_rows & write); });
  return begun == batches.size();
}

bool run(const Study& study, Store& store, const RunSettings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  const Design design{study};
  const std::uint64_t before = store.rows_done(), size = store.batch_size();
  const auto tell = [&] {
    if (!settings.progress) return;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    settings.progress({.rows_done = store.rows_done(),
                       .rows = store.rows(),
                       .seconds = passed.count(),
                       .rows_before = before});
  };
  const BatchWork work{.worker =
                           [&] {
                             auto worker = std::make_shared<Worker>(study, design);
                             return [worker, size](std::uint64_t batch, std::vector<StoredRow>& rows) {
                               worker->compute(batch, size, rows);
                             };
                           },
                       .write =
                           [&](std::uint64_t batch, std::span<const StoredRow> rows) {
                             store.write_batch(batch, rows);
                             tell();
                           }};
  tell();
  const std::vector<std::uint64_t> missing = store.missing_batches();
  return run_batches(missing, settings.threads, settings.stop, work);
}

}  // namespace dashpad::study
