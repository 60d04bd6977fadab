// A study on ranks: rank 0 distributes the batches, computes some itself, and writes all results.

#include <chrono>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "dashpad/version.hpp"
#include "mpi/ranks.hpp"
#include "output.hpp"
#include "progress_line.hpp"
#include "study/study.hpp"

namespace dashpad::app {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::microseconds nap{200};  ///< between two looks for letters; a batch takes far longer

std::string text_of(const Message& numbers) {
  std::string text;
  for (const std::uint64_t number : numbers) text += static_cast<char>(number);
  return text;
}

/// The work of rank 0. One thread computes; the other one serves, writes and sleeps in between, so that one
/// core is enough for both.
class StudyScheduler {
 public:
  StudyScheduler(const study::Study& study, study::Store& store, int other_ranks)
      : study_(study),
        store_(store),
        design_(study),
        open_ranks_(other_ranks),
        rows_done_(store.rows_done()) {
    const std::vector<std::uint64_t> missing = store.missing_batches();
    batches_.assign(missing.begin(), missing.end());
  }

  /// Serves until every rank is told to stop. True if all rows are there. Throws what went wrong in a rank or
  /// in writing, after the batches at hand.
  bool serve(const std::function<void(const study::Progress&)>& progress) {
    const auto begin = Clock::now();
    const std::uint64_t before = rows_done_, rows = design_.rows();
    std::thread computing{[this] { compute(); }};
    const auto is_computing = [this] {
      const std::lock_guard lock{mutex_};
      return computing_ || !own_.empty();
    };
    while (open_ranks_ > 0 || is_computing()) {
      const std::optional<Letter> letter = Ranks::next_letter();
      if (letter) answer(*letter);
      const std::optional<BatchReport> own = taken_from(own_);
      if (own) write(*own);
      if (!letter && !own) {
        std::this_thread::sleep_for(nap);
        continue;
      }
      progress({rows_done_, rows, std::chrono::duration<double>(Clock::now() - begin).count(), before});
    }
    computing.join();
    if (failure_) std::rethrow_exception(failure_);
    return rows_done_ == rows;
  }

 private:
  /// The first entry of a queue that both threads use.
  template <class T>
  std::optional<T> taken_from(std::deque<T>& queue) {
    const std::lock_guard lock{mutex_};
    if (queue.empty()) return std::nullopt;
    T first = std::move(queue.front());
    queue.pop_front();
    return first;
  }

  std::optional<std::uint64_t> next_batch() {
    return StopSignal::wanted() ? std::nullopt : taken_from(batches_);
  }

  /// Leaves the batches that are not handed out yet to the next run.
  void close() {
    const std::lock_guard lock{mutex_};
    batches_.clear();
  }

  void fail(std::exception_ptr failure) {
    close();
    const std::lock_guard lock{mutex_};
    if (!failure_) failure_ = std::move(failure);
  }

  void compute() {
    try {
      study::Worker worker{study_, design_};
      const std::uint64_t size = store_.batch_size();
      while (const std::optional<std::uint64_t> batch = next_batch()) {
        BatchReport report{.batch = *batch, .rows = worker.compute(*batch, size)};
        const std::lock_guard lock{mutex_};
        own_.push_back(std::move(report));
      }
    } catch (...) {
      fail(std::current_exception());
    }
    const std::lock_guard lock{mutex_};
    computing_ = false;
  }

  void answer(const Letter& letter) {
    BatchReport report;
    if (letter.tag == Tag::result) report = unpacked(letter.numbers);
    if (letter.tag == Tag::failure)
      fail(std::make_exception_ptr(std::runtime_error(text_of(letter.numbers))));
    if (report.stop_wanted) close();
    // The rank goes on while this one writes.
    const std::optional<std::uint64_t> next = letter.tag == Tag::failure ? std::nullopt : next_batch();
    if (next)
      Ranks::send(letter.rank, Tag::batch, {*next});
    else
      Ranks::send(letter.rank, Tag::stop, {});
    if (!next) --open_ranks_;
    if (letter.tag == Tag::result) write(report);
  }

  void write(const BatchReport& report) {
    if (failure_) return;  // after a full disk nothing more is tried
    try {
      store_.write_batch(report.batch, report.rows);
      rows_done_ += report.rows.size();
    } catch (...) {
      fail(std::current_exception());
    }
  }

  const study::Study& study_;
  study::Store& store_;
  study::Design design_;
  int open_ranks_ = 0;
  std::uint64_t rows_done_ = 0;

  std::mutex mutex_;  ///< guards the members below
  std::deque<std::uint64_t> batches_;
  std::deque<BatchReport> own_;
  bool computing_ = true;
  std::exception_ptr failure_;
};

/// Runs a first step on a rank. Returns its errors, which all must know.
template <class Step>
std::vector<std::string> complaints_of(Step step) {
  try {
    step();
    return {};
  } catch (const input::InputError& error) {
    return lines(error.faults());
  } catch (const Refused& error) {
    return error.complaints();
  } catch (const std::exception& error) {
    return {error.what()};
  }
}

/// Called by all. True if no rank has complaints; else throws on the first one that has, for one message.
bool is_agreed(const Ranks& ranks, std::vector<std::string> complaints) {
  const std::optional<int> first = ranks.first_with(!complaints.empty());
  if (!first) return true;
  if (*first != ranks.rank()) return false;
  if (!ranks.is_first())
    for (std::string& line : complaints) line = fmt::format("rank {}: {}", ranks.rank(), line);
  throw Refused(std::move(complaints));
}

/// Called by all: differences between the ranks that would give rows that do not belong together.
std::vector<std::string> differences(const Ranks& ranks, const study::Study& study,
                                     const std::string& study_file) {
  const auto same = [&](std::string_view text) {
    return ranks.is_same_for_all(std::hash<std::string_view>{}(text));
  };
  const bool one_program = same(fmt::format("{} {}", version(), build_facts().git_commit));
  const bool one_text = same(study.text), one_study = same(study::resolved_text(study));
  if (!one_program) return {"dashpad: the version or commit differs between ranks"};
  if (!one_text) return {study_file + ": differs between ranks"};
  if (one_study) return {};
  return {study_file + ": its base case, or a card or a data file that it names, differs between ranks"};
}

/// The work of all ranks but the first.
void compute_what_is_asked(const study::Study& study, std::uint64_t batch_size, int rank) {
  const study::Design design{study};
  study::Worker worker{study, design};
  Ranks::send(0, Tag::ready, {});
  for (Letter order = Ranks::receive(0); order.tag == Tag::batch; order = Ranks::receive(0)) {
    try {
      const std::uint64_t batch = order.numbers.at(0);
      std::vector<study::StoredRow> rows = worker.compute(batch, batch_size);
      Ranks::send(0, Tag::result,
                  packed({.batch = batch, .stop_wanted = StopSignal::wanted(), .rows = std::move(rows)}));
    } catch (const std::exception& error) {
      const std::string text = fmt::format("rank {}: {}", rank, error.what());
      Ranks::send(0, Tag::failure, {text.begin(), text.end()});
    }
  }
}

int lead(const study::Study& study, study::Store& store, const StudyRequest& request, int other_ranks) {
  const auto begin = std::chrono::steady_clock::now();
  const std::uint64_t before = store.rows_done();
  StudyScheduler scheduler{study, store, other_ranks};
  bool complete = false;
  {
    StudyProgress shown{request.quiet};
    complete = scheduler.serve([&](const study::Progress& now) { shown.show(now); });
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return finish_study(store, request, before, taken.count(), complete);
}

}  // namespace

int run_on_ranks(const StudyRequest& request) {
  const Ranks ranks;
  const StopSignal stop;
  std::optional<study::Study> study;
  std::optional<study::Store> store;
  const auto read = [&] {
    if (request.threads > 1)
      throw Refused({"--threads: under mpirun, each rank computes on one core; set the number of ranks"});
    study = study_of(request);
  };
  // Other ranks end with 0, because mpirun ends all at the first other exit code, before the message is out.
  if (!is_agreed(ranks, complaints_of(read))) return exit_done;
  const std::vector<std::string> differing = differences(ranks, *study, request.study_file);
  const auto open = [&] {
    if (!differing.empty()) throw Refused(differing);
    if (ranks.is_first()) store.emplace(open_store(*study, request));
  };
  if (!is_agreed(ranks, complaints_of(open))) return exit_done;

  const std::uint64_t batch_size = ranks.of_first(store ? store->batch_size() : 0);
  if (ranks.is_first()) return lead(*study, *store, request, ranks.size() - 1);
  compute_what_is_asked(*study, batch_size, ranks.rank());
  return exit_done;
}

}  // namespace dashpad::app
