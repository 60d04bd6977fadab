#include "study/run_batches.hpp"

#include <vector>

#include <oneapi/tbb/concurrent_queue.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

namespace dashpad::study {

namespace {

namespace tbb = oneapi::tbb;

struct Computed {
  std::uint64_t batch = 0;
  std::vector<StoredRow> rows;
};

}  // namespace

bool run_batches(std::span<const std::uint64_t> batches, int threads, const std::atomic<bool>* stop,
                 const BatchWork& work) {
  constexpr std::size_t batches_a_thread = 4;
  const auto workers = static_cast<std::size_t>(threads);
  // More threads than cores, where the user wants it.
  const tbb::global_control allowed{tbb::global_control::max_allowed_parallelism, workers};
  tbb::enumerable_thread_specific<BatchWork::Compute> compute{[&work] { return work.worker(); }};

  // What is on its way when a filter throws is forgotten by the pipeline: it is owned here, and pointed at.
  std::vector<Computed> in_flight(batches_a_thread * workers);
  tbb::concurrent_queue<Computed*> unused;
  for (Computed& of : in_flight) unused.push(&of);
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
  // In order: the file grows at its end, which is fastest, and holds the same bytes whatever the threads.
  const auto write =
      tbb::make_filter<Computed*, void>(tbb::filter_mode::serial_in_order, [&](Computed* done) {
        work.write(done->batch, done->rows);
        unused.push(done);
      });

  tbb::task_arena arena{threads};
  arena.execute([&] { tbb::parallel_pipeline(in_flight.size(), next & compute_rows & write); });
  return begun == batches.size();
}

}  // namespace dashpad::study
