#pragma once
/// Computing the rows of a study: one batch, or all missing rows on all cores or MPI ranks.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::uncertainty {
class FoamDraw;
}

namespace dashpad::study {

/// A worker with its solver and case, one for each thread. Study and design must outlive it.
class Worker {
 public:
  Worker(const Study& study, const Design& design);
  ~Worker();
  Worker(Worker&&) noexcept;
  /// Computes rows batch * size to (batch + 1) * size - 1, as far as the design has them. Rows whose factors
  /// make no valid case get the status not_run and NaN everywhere.
  std::vector<StoredRow> compute(std::uint64_t batch, std::uint64_t size);
  /// The same into rows that were used before, whose memory is used again.
  void compute(std::uint64_t batch, std::uint64_t size, std::vector<StoredRow>& rows);
  /// The case of a row; if its foam is drawn, the impact of the card as it is is solved first. Throws
  /// std::invalid_argument if its factors make no valid case, and std::out_of_range for a row that the design
  /// does not have.
  const ImpactCase& case_of(std::uint64_t row);
  /// Solves case_of() a row with its history, for its outcome.
  Solution replay(std::uint64_t row, Outcome& outcome);

 private:
  void compute_row(std::uint64_t row, StoredRow& result);
  const Solution& solve(Outcome& outcome);

  const Study& study_;
  const Design& design_;
  Application application_;
  ResponseReader responses_;
  Solver solver_;
  ImpactCase impact_;
  std::vector<double> factors_;
  std::vector<std::size_t> of_foam_;  ///< places of the factors that draw what is uncertain of the foam
  std::unique_ptr<const uncertainty::FoamDraw> draw_;  ///< of the row at hand, if any
};

struct Progress {
  std::uint64_t rows_done = 0, rows = 0;
  double seconds = 0;             ///< since this run began
  std::uint64_t rows_before = 0;  ///< done by earlier runs
};

struct RunSettings {
  int threads = 0;                                     ///< 0: all cores
  const std::atomic<bool>* stop = nullptr;             ///< set to finish the batches at hand and return
  std::function<void(const Progress&)> progress = {};  ///< called from one thread at a time
};

/// Computes the missing rows. True if all rows are there at the end, false if it was stopped. Faults in
/// writing are thrown after the batches at hand: std::runtime_error.
///
/// Example:
/// \code
/// #include "dashpad/study/study_file.hpp"
/// const auto study = dashpad::study::read_study("study.toml", "materials", "standards").value();
/// auto store = dashpad::study::Store::open_for(study, "study.sqlite");
/// if (dashpad::study::run(study, store, {.threads = 4})) std::puts("all rows are there");
/// \endcode
bool run(const Study& study, Store& store, const RunSettings& settings = {});

}  // namespace dashpad::study
