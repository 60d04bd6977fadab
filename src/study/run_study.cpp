#include "dashpad/study/run_study.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "dashpad/study/batch.hpp"
#include "dashpad/study/design.hpp"
#include "study/run_batches.hpp"

namespace dashpad::study {

namespace {

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

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
  return run_batches(missing, settings.threads > 0 ? settings.threads : cores(), settings.stop, work);
}

}  // namespace dashpad::study
