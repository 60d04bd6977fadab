#include "mpi/scheduler.hpp"

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "study/stop_signal.hpp"

namespace dashpad::app {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::microseconds nap{200};  ///< between two looks for letters; a batch takes far longer

std::string text_of(const Message& numbers) {
  std::string text;
  for (const std::uint64_t number : numbers) text += static_cast<char>(number);
  return text;
}

}  // namespace

StudyScheduler::StudyScheduler(const study::Study& study, study::Store& store, int other_ranks)
    : study_(study), store_(store), design_(study), open_ranks_(other_ranks), rows_done_(store.rows_done()) {
  const std::vector<std::uint64_t> missing = store.missing_batches();
  batches_.assign(missing.begin(), missing.end());
}

std::optional<std::uint64_t> StudyScheduler::next_batch() {
  const std::lock_guard lock{mutex_};
  if (StopSignal::wanted() || batches_.empty()) return std::nullopt;
  const std::uint64_t batch = batches_.front();
  batches_.pop_front();
  return batch;
}

/// Whatever is not handed out yet stays for the next run.
void StudyScheduler::close() {
  const std::lock_guard lock{mutex_};
  batches_.clear();
}

void StudyScheduler::fail(std::exception_ptr failure) {
  close();
  const std::lock_guard lock{mutex_};
  if (!failure_) failure_ = std::move(failure);
}

void StudyScheduler::compute() {
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

std::optional<BatchReport> StudyScheduler::own_report() {
  const std::lock_guard lock{mutex_};
  if (own_.empty()) return std::nullopt;
  BatchReport report = std::move(own_.front());
  own_.pop_front();
  return report;
}

void StudyScheduler::write(const BatchReport& report) {
  if (failure_) return;  // after a full disk nothing more is tried
  try {
    store_.write_batch(report.batch, report.rows);
    rows_done_ += report.rows.size();
  } catch (...) {
    fail(std::current_exception());
  }
}

void StudyScheduler::answer(const Letter& letter) {
  BatchReport report;
  if (letter.tag == Tag::result) report = unpacked(letter.numbers);
  if (letter.tag == Tag::failure) fail(std::make_exception_ptr(std::runtime_error(text_of(letter.numbers))));
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

bool StudyScheduler::serve(const std::function<void(const study::Progress&)>& progress) {
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
    const std::optional<BatchReport> own = own_report();
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

}  // namespace dashpad::app
