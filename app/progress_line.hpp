#pragma once
/// Progress of long computations on standard error, and requests to stop them.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "dashpad/study/run_study.hpp"

namespace dashpad::app {

class TerminalLine {
 public:
  TerminalLine();
  /// Wipes the line.
  ~TerminalLine() { wipe(); }
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  /// Whether standard error is a terminal; draw() is only for one.
  [[nodiscard]] bool is_terminal() const { return terminal_; }
  /// Replaces what was drawn before.
  void draw(const std::string& line);
  /// Leaves an empty line for other text.
  void wipe();

 private:
  bool terminal_ = false;
  std::string drawn_;
  std::size_t width_ = 0;  ///< of the longest line so far
};

/// `done` of `all` in thirty characters: "######........................"; full if all is 0.
std::string progress_bar(std::uint64_t done, std::uint64_t all);

/// A line with the elapsed time and, if known, the share done, from the second second on, if standard error
/// is a terminal; wiped at the end. A computation of more than a minute is announced once, on any output.
class ProgressLine {
 public:
  enum class Elsewhere {
    silent,
    lines,  ///< without a terminal, a line after 1, 10, 30 and 60 s, then every minute
  };

  /// `what` describes the computation: "Simulating the tests".
  explicit ProgressLine(std::string what, Elsewhere elsewhere = Elsewhere::silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Callable from any thread.
  void show(std::size_t done, std::size_t all);
  /// Announces the duration at once if it is more than a minute.
  void expect(double seconds);
  /// Begins the next step.
  void now(std::string what);

 private:
  void tick(const std::stop_token& stop);
  void draw(double seconds);
  void add_line(double seconds);
  void say_how_long(double seconds);
  void say(double seconds);

  std::string what_;
  std::atomic<double> share_ = 0;  ///< done, of 1; 0 if unknown
  bool said_how_long_ = false;
  const Elsewhere elsewhere_;
  double next_line_;  ///< s
  TerminalLine line_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread clock_;
};

class StudyProgress {
 public:
  explicit StudyProgress(bool quiet);

  void show(const study::Progress& progress);

 private:
  bool quiet_ = false;
  TerminalLine line_;
  double next_ = 0;  ///< s, of the next update
};

/// "1:02:03", "2:03" or "12 s".
std::string clock_text(double seconds);
/// "812 rows/s", "12.3 thousand rows/s".
std::string rate_text(double rows, double seconds);

/// While this lives, the first SIGINT, SIGTERM or SIGHUP sets wanted(), and the second ends the program at
/// once. A signal that was ignored before (nohup) stays ignored. Only one may exist.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  [[nodiscard]] static const std::atomic<bool>& wanted();
  /// 128 plus the number of the signal, as in shells.
  [[nodiscard]] static int exit_code();
};

}  // namespace dashpad::app
