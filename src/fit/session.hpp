#pragma once
/// What goes along with a fit while it runs: the wish to stop, the progress, and what is kept of finished
/// pieces of work.

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "dashpad/fit/report.hpp"
#include "fit/profile.hpp"
#include "fit/solve.hpp"

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

}  // namespace dashpad::fit
