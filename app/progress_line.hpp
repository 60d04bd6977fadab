#pragma once
/// What a person hears of a computation that takes a while, on standard error.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "terminal_line.hpp"

namespace dashpad::app {

/// A line with the time since it was made and, if the computation tells, how much is done; from its second
/// second on, where standard error is a terminal. Wiped at the end. What will take more than a minute says so
/// once, also where it is no terminal.
class ProgressLine {
 public:
  enum class Elsewhere {
    silent,
    lines,  ///< where standard error is no terminal: a line after 1, 10, 30 and 60 s, then every minute
  };

  /// `what` is going on: "Simulating the tests".
  explicit ProgressLine(std::string what, Elsewhere elsewhere = Elsewhere::silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `done` of `all`; from any thread.
  void show(std::size_t done, std::size_t all);
  /// Says at once that it takes so many seconds, if that is more than a minute.
  void expect(double seconds);
  /// The next step.
  void now(std::string what);

 private:
  void tick(const std::stop_token& stop);
  void draw(double seconds);
  void add_line(double seconds);
  void say_how_long(double seconds);
  void say(double seconds);

  std::string what_;
  std::atomic<double> share_ = 0;  ///< done, of 1; 0 as long as the computation does not tell
  bool said_how_long_ = false;
  const Elsewhere elsewhere_;
  double next_line_;  ///< s
  TerminalLine line_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread clock_;
};

}  // namespace dashpad::app
