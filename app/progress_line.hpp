#pragma once
/// How far a long computation is, on standard error where that is a terminal. Elsewhere it is silent.

#include <cstddef>
#include <mutex>
#include <string>

namespace dashpad {

class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  /// Wipes the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `done` of `all`; from any thread.
  void show(std::size_t done, std::size_t all);

 private:
  std::string what_;
  bool terminal_ = false;
  std::mutex mutex_;
  std::string shown_;
};

}  // namespace dashpad
