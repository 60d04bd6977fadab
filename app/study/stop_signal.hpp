#pragma once
/// Ctrl-C and SIGTERM as a wish: the work at hand is finished first.

#include <atomic>

namespace dashpad::app {

/// While this lives, the first SIGINT, SIGTERM or SIGHUP sets wanted(); the second one ends the program at
/// once, as it does elsewhere. A signal that is ignored at the beginning (nohup) stays ignored. One at a
/// time.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  [[nodiscard]] static const std::atomic<bool>& wanted();
  /// 128 and the number of the signal, as a shell reports it.
  [[nodiscard]] static int exit_code();
};

}  // namespace dashpad::app
