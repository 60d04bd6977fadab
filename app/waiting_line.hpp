#pragma once
/// What the command is at, and for how long already, on standard error where that is a terminal: for steps
/// whose length nobody knows. Silent elsewhere and in the first second.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "terminal_line.hpp"

namespace dashpad {

class WaitingLine {
 public:
  /// "Reading drop.csv".
  explicit WaitingLine(std::string what);

  /// The next step.
  void now(std::string what);

 private:
  void run(const std::stop_token& stop);

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::string what_;
  TerminalLine line_;
  std::jthread thread_;  ///< the last member: it ends before the line is wiped
};

}  // namespace dashpad
