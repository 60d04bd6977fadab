// Running a study: the rows depend on nothing but the study.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

#include "dashpad/study/run_study.hpp"
#include "shared/temporary_folder.hpp"
#include "small_study.hpp"
#include "study/run_batches.hpp"

namespace dashpad::test {
namespace {

using study::Store;
using study::StoredRow;

std::vector<std::uint64_t> numbers(std::uint64_t count) {
  std::vector<std::uint64_t> list(count);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

class RunStudy : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name = "study.db") const {
    return folder_.path() / name;
  }

  int refusals_ = 0;

 private:
  test::TemporaryFolder folder_;
};

std::vector<StoredRow> all_rows(const Store& store) {
  std::vector<StoredRow> rows;
  store.visit_rows([&](const StoredRow& row) { rows.push_back(row); });
  return rows;
}

void expect_same_rows(const Store& got, const Store& expected) {
  const auto first = all_rows(got), second = all_rows(expected);
  ASSERT_EQ(first.size(), expected.rows());
  ASSERT_EQ(second.size(), expected.rows());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].row, second[i].row);
    ASSERT_EQ(first[i].factors, second[i].factors);
    ASSERT_EQ(first[i].outcome.status, second[i].outcome.status);
    ASSERT_EQ(first[i].outcome.error, second[i].outcome.error);
    ASSERT_EQ(first[i].outcome.values, second[i].outcome.values);
  }
}

TEST_F(RunStudy, gives_the_same_rows_on_any_number_of_threads) {
  const study::Study study = small_study(500);
  Store one = Store::open_for(study, file("1"));
  ASSERT_TRUE(study::run(study, one, {.threads = 1}));
  EXPECT_GT(one.row(499)->outcome.values.at(0), one.row(0)->outcome.values.at(0)) << "faster is harder";
  for (const int threads : {2, 5}) {
    Store several = Store::open_for(study, file(std::to_string(threads)));
    ASSERT_TRUE(study::run(study, several, {.threads = threads}));
    expect_same_rows(several, one);
  }
}

TEST_F(RunStudy, goes_on_where_it_was_stopped) {
  const study::Study study = small_study(500);
  Store whole = Store::open_for(study, file("whole"));
  ASSERT_TRUE(study::run(study, whole, {}));
  std::uint64_t done = 0;
  for (int begun = 0; done < 500; ++begun) {
    ASSERT_LT(begun, 500) << "every start must get on";
    Store store = Store::open_for(study, file());
    std::atomic<bool> stop = false;
    const auto stop_after_a_batch = [&](const study::Progress& progress) {
      EXPECT_EQ(progress.rows, 500U);
      EXPECT_EQ(progress.rows_before, done);
      stop = progress.rows_done > done;
    };
    const bool finished =
        study::run(study, store, {.threads = 2, .stop = &stop, .progress = stop_after_a_batch});
    EXPECT_GT(store.rows_done(), done);
    EXPECT_EQ(finished, store.rows_done() == 500);
    done = store.rows_done();
  }
  expect_same_rows(Store::open_to_read(file()), whole);
}

study::Study drawn_study(study::Sampling sampling, std::uint64_t samples, bool indices = false) {
  study::Study study = small_study();
  study.text = "samples = " + std::to_string(samples) + "\n";
  study.factors = {
      {.key = "impactor.speed", .unit = "m/s", .spread = study::Uniform{1, 2}, .lowest = {}, .highest = {}},
      {.key = "impactor.mass", .unit = "kg", .spread = study::Uniform{4, 5}, .lowest = {}, .highest = {}}};
  study.sampling = sampling;
  study.samples = samples;
  study.indices = indices;
  return study;
}

/// 300 rows are batches of four, so that the last batch of 298 is half full.
TEST_F(RunStudy, with_more_draws_has_the_rows_that_it_would_have_had) {
  for (const study::Sampling sampling : {study::Sampling::sobol, study::Sampling::monte_carlo})
    for (const bool indices : {false, true}) {
      const auto of = [&](std::uint64_t samples) { return drawn_study(sampling, samples, indices); };
      const std::string name = std::to_string(static_cast<int>(sampling)) + std::to_string(int{indices});
      {
        Store store = Store::open_for(of(298), file(name));
        ASSERT_TRUE(study::run(of(298), store, {}));
      }
      EXPECT_THROW(Store::open_for(of(333), file(name)), std::runtime_error);
      Store more = Store::open_for(of(333), file(name), true);
      EXPECT_GE(more.rows_done(), 296U);
      EXPECT_LE(more.rows_done(), 298U * (indices ? 4 : 1));
      ASSERT_TRUE(study::run(of(333), more, {}));
      EXPECT_TRUE(more.is_of(of(333)));
      Store whole = Store::open_for(of(333), file(name + "whole"));
      ASSERT_TRUE(study::run(of(333), whole, {}));
      expect_same_rows(more, whole);
    }
}

TEST_F(RunStudy, says_why_more_draws_cannot_be_taken_up) {
  const auto refusal = [&](const study::Study& finished, const study::Study& wanted, bool extend) {
    const std::string name = "refused" + std::to_string(refusals_++);
    { Store::open_for(finished, file(name)); }
    try {
      Store::open_for(wanted, file(name), extend);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using enum study::Sampling;
  EXPECT_THAT(refusal(drawn_study(sobol, 16), drawn_study(sobol, 32), false),
              testing::HasSubstr("has 16 rows where the study has 32; use --extend to keep these rows"));
  EXPECT_THAT(refusal(drawn_study(sobol, 32), drawn_study(sobol, 16), true),
              testing::HasSubstr("give another name"));
  EXPECT_THAT(refusal(drawn_study(latin_hypercube, 16), drawn_study(latin_hypercube, 32), true),
              testing::HasSubstr("the draws of a Latin hypercube change with their number"));
  study::Study other = drawn_study(sobol, 32);
  other.seed = 2;
  EXPECT_THAT(refusal(drawn_study(sobol, 16), other, true), testing::HasSubstr("a different study"));
}

TEST_F(RunStudy, has_nothing_to_do_for_a_finished_one) {
  const study::Study study = small_study(100);
  Store store = Store::open_for(study, file());
  fill(store);
  ASSERT_TRUE(study::run(study, store, {}));
  EXPECT_EQ(store.row(5)->outcome.values.at(0), made_up_row(5).outcome.values.at(0)) << "not computed again";
}

TEST(RunBatches, computes_each_once_and_writes_in_order) {
  std::vector<std::uint64_t> written;
  std::atomic<int> computed = 0;
  const study::BatchWork work{.worker =
                                  [&] {
                                    return [&](std::uint64_t batch, std::vector<StoredRow>& rows) {
                                      ++computed;
                                      rows.assign(1, made_up_row(batch));
                                    };
                                  },
                              .write =
                                  [&](std::uint64_t batch, std::span<const StoredRow> rows) {
                                    EXPECT_EQ(rows[0].row, batch);
                                    written.push_back(batch);
                                  }};
  for (const int threads : {1, 2, 5}) {
    written.clear();
    computed = 0;
    EXPECT_TRUE(study::run_batches(numbers(1000), threads, nullptr, work));
    EXPECT_EQ(written, numbers(1000));
    EXPECT_EQ(computed, 1000);
  }
  EXPECT_TRUE(study::run_batches({}, 2, nullptr, work));
}

/// Rows come back to be filled again: no more lists are made than batches are under way.
TEST(RunBatches, uses_the_memory_of_written_rows_again) {
  std::atomic<int> fresh = 0;
  const study::BatchWork work{.worker =
                                  [&] {
                                    return [&](std::uint64_t batch, std::vector<StoredRow>& rows) {
                                      if (rows.capacity() == 0) ++fresh;
                                      rows.assign(1, made_up_row(batch));
                                    };
                                  },
                              .write = [](std::uint64_t, std::span<const StoredRow>) {}};
  EXPECT_TRUE(study::run_batches(numbers(1000), 3, nullptr, work));
  EXPECT_LE(fresh, 12);
}

TEST(RunBatches, gives_each_thread_a_worker_of_its_own) {
  std::atomic<int> workers = 0;
  std::mutex mutex;
  std::set<std::thread::id> threads;
  const auto late = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  const study::BatchWork work{.worker =
                                  [&] {
                                    ++workers;
                                    return [&, owner = std::this_thread::get_id()](
                                               std::uint64_t batch, std::vector<StoredRow>& rows) {
                                      EXPECT_EQ(owner, std::this_thread::get_id());
                                      // The first one waits for company, so that it cannot do all the work
                                      // itself.
                                      while (workers < 2 && std::chrono::steady_clock::now() < late)
                                        std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                      const std::lock_guard lock(mutex);
                                      threads.insert(owner);
                                      rows.assign(1, made_up_row(batch));
                                    };
                                  },
                              .write = [](std::uint64_t, std::span<const StoredRow>) {}};
  EXPECT_TRUE(study::run_batches(numbers(200), 5, nullptr, work));
  EXPECT_EQ(static_cast<std::size_t>(workers.load()), threads.size());
  EXPECT_LE(workers, 5);
  EXPECT_GT(workers, 1) << "more threads than one do the work";
}

TEST(RunBatches, holds_a_few_batches_in_memory_however_slow_the_disk) {
  std::atomic<int> waiting = 0, most = 0;
  const study::BatchWork work{.worker =
                                  [&] {
                                    return [&](std::uint64_t batch, std::vector<StoredRow>& rows) {
                                      most = std::max(most.load(), ++waiting);
                                      rows.assign(1, made_up_row(batch));
                                    };
                                  },
                              .write =
                                  [&](std::uint64_t, std::span<const StoredRow>) {
                                    std::this_thread::sleep_for(std::chrono::microseconds(300));
                                    --waiting;
                                  }};
  EXPECT_TRUE(study::run_batches(numbers(500), 3, nullptr, work));
  EXPECT_LE(most, 12);
}

TEST(RunBatches, ends_with_the_exception_of_the_writer_or_of_a_worker) {
  for (const bool writer_fails : {true, false}) {
    std::vector<std::uint64_t> written;
    const study::BatchWork work{.worker =
                                    [&] {
                                      return [&](std::uint64_t batch, std::vector<StoredRow>& rows) {
                                        if (!writer_fails && batch == 20)
                                          throw std::runtime_error("no memory");
                                        rows.assign(1, made_up_row(batch));
                                      };
                                    },
                                .write =
                                    [&](std::uint64_t batch, std::span<const StoredRow>) {
                                      if (writer_fails && batch == 20)
                                        throw std::runtime_error("the disk is full");
                                      written.push_back(batch);
                                    }};
    EXPECT_THROW(study::run_batches(numbers(100'000), 2, nullptr, work), std::runtime_error);
    EXPECT_LE(written.size(), 20U);
    EXPECT_EQ(written, numbers(written.size()));
    if (writer_fails) {
      EXPECT_EQ(written.size(), 20U);
    }
  }
}

TEST(RunBatches, writes_what_is_computed_when_it_is_told_to_stop) {
  std::atomic<bool> stop = false;
  std::atomic<std::uint64_t> computed = 0, written = 0;
  const study::BatchWork work{.worker =
                                  [&] {
                                    return [&](std::uint64_t batch, std::vector<StoredRow>& rows) {
                                      if (++computed == 10) stop = true;
                                      rows.assign(1, made_up_row(batch));
                                    };
                                  },
                              .write = [&](std::uint64_t, std::span<const StoredRow>) { ++written; }};
  EXPECT_FALSE(study::run_batches(numbers(100'000), 2, &stop, work));
  EXPECT_EQ(written, computed);
  EXPECT_GE(written, 10U);
  EXPECT_LT(written, 100U);
}

}  // namespace
}  // namespace dashpad::test
