#pragma once
/// How far a long computation is, on standard error where that is a terminal. Elsewhere it is silent.

#include <cstddef>
#include <mutex>
#include <string>

#include "terminal_line.hpp"

namespace dashpad {

class ProgressLine {
 public:
  explicit ProgressLine(std::string what);

  /// `done` of `all`; from any thread.
  void show(std::size_t done, std::size_t all);

 private:
  std::string what_;
  std::mutex mutex_;
  TerminalLine line_;
};

}  // namespace dashpad
