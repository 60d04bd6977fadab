#include "mpi/study_ranks.hpp"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "dashpad/study/batch.hpp"
#include "dashpad/study/resolved_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "dashpad/version.hpp"
#include "mpi/ranks.hpp"
#include "mpi/scheduler.hpp"
#include "streams.hpp"
#include "study/progress.hpp"
#include "study/stop_signal.hpp"

namespace dashpad::app {

namespace {

/// Runs a step of the beginning on a rank. What goes wrong is for all to know.
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

/// Called by all. True where nothing is wrong on any rank; throws on the first one that has complaints, so
/// that there is one message.
bool is_agreed(const Ranks& ranks, std::vector<std::string> complaints) {
  const std::optional<int> first = ranks.first_with(!complaints.empty());
  if (!first) return true;
  if (*first != ranks.rank()) return false;
  if (!ranks.is_first())
    for (std::string& line : complaints) line = fmt::format("rank {}: {}", ranks.rank(), line);
  throw Refused(std::move(complaints));
}

/// Called by all: what is not the same on all ranks, and would give rows that do not belong together.
std::vector<std::string> differences(const Ranks& ranks, const study::Study& study,
                                     const std::string& study_file) {
  const auto same = [&](std::string_view text) {
    return ranks.is_same_for_all(std::hash<std::string_view>{}(text));
  };
  const bool one_program = same(fmt::format("{} {}", version(), build_facts().git_commit));
  const bool one_text = same(study.text), one_study = same(study::resolved_text(study));
  if (!one_program) return {"dashpad: is not the same version and commit for all ranks"};
  if (!one_text) return {study_file + ": is not the same file for all ranks"};
  if (one_study) return {};
  return {study_file +
          ": its base case, or a card or a data file that it names, is not the same for all ranks"};
}

Message numbers_of(const std::string& text) { return {text.begin(), text.end()}; }

/// What all ranks but the first do.
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
      Ranks::send(0, Tag::failure, numbers_of(fmt::format("rank {}: {}", rank, error.what())));
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

int run_on(const Ranks& ranks, const StudyRequest& request, const std::filesystem::path& materials) {
  const StopSignal stop;
  std::optional<study::Study> study;
  std::optional<study::Store> store;
  const auto read = [&] {
    if (request.threads > 1)
      throw Refused({"--threads: under mpirun each rank computes on one core; choose the number of ranks"});
    study = study::read_study(request.study_file, materials).value();
  };
  // Silent ranks end well: mpirun ends all at the first exit code that is not 0, and the message must be out.
  if (!is_agreed(ranks, complaints_of(read))) return exit_done;
  const std::vector<std::string> differing = differences(ranks, *study, request.study_file);
  const auto open = [&] {
    if (!differing.empty()) throw Refused(differing);
    if (ranks.is_first()) store.emplace(open_store(*study, request.store_file));
  };
  if (!is_agreed(ranks, complaints_of(open))) return exit_done;

  const std::uint64_t batch_size = ranks.of_first(store ? store->batch_size() : 0);
  if (ranks.is_first()) return lead(*study, *store, request, ranks.size() - 1);
  compute_what_is_asked(*study, batch_size, ranks.rank());
  return exit_done;
}

}  // namespace

int run_on_ranks(const StudyRequest& request, const std::filesystem::path& materials) {
  const Ranks ranks;
  return run_on(ranks, request, materials);
}

}  // namespace dashpad::app
