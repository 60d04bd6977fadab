#pragma once
/// From the starts to the best minimum with its uncertainty, and what goes along while that runs: the wish to
/// stop, the progress, and what is kept of finished pieces of work.

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "dashpad/fit/report.hpp"
#include "fit/problem.hpp"
#include "fit/solve.hpp"
#include "fit/uncertainty.hpp"

namespace dashpad::fit {

/// For several threads.
class Session {
 public:
  /// Reads what is kept. Throws as check_state() does.
  Session(const Fit& fit, const RunOptions& options);

  [[nodiscard]] bool is_stopped() const { return options_.stop != nullptr && *options_.stop; }
  void throw_if_stopped() const;

  /// A kind of work begins, in so many pieces.
  void begin(const char* what, std::size_t pieces);

  /// The piece of that name: kept from before, or computed now and kept. The names of a fit are the same each
  /// time, and pieces depend on nothing but the fit and the pieces before.
  Minimum piece(const std::string& name, const std::function<Minimum()>& compute);
  ProfileEnd piece(const std::string& name, const std::function<ProfileEnd()>& compute);

 private:
  /// Pieces as JSON texts, by their names.
  template <class Result>
  Result recalled(const std::string& name, const std::function<Result()>& compute);
  void finished(const std::string& name, const std::string& text);

  const RunOptions& options_;
  mutable std::mutex mutex_;  ///< of all that follows
  std::map<std::string, std::string> kept_;
  const char* what_ = "";
  std::size_t done_ = 0, pieces_ = 0;
};

/// The problem as searches see it. They end soon once the session is stopped.
LeastSquares least_squares_of(const Problem& problem, const Session& session,
                              std::atomic<std::size_t>& evaluations);

/// The best of the starts that converged, or the best of all. The report gets how many came to it.
Minimum search(const Fit& fit, const Problem& problem, const LeastSquares& residuals, Session& session,
               FitReport& report);

struct Solved {
  Minimum minimum;
  Uncertainty uncertainty;
  std::vector<ProfileEnd> below, above;  ///< of each coordinate
};

/// From a minimum to the best one that profiles from there meet, with its profiles; report.converged says
/// whether it is one. Noise that nobody stated is put into the problem.
Solved determine(Problem& problem, const LeastSquares& residuals, Minimum minimum, Session& session,
                 FitReport& report);

}  // namespace dashpad::fit
