#include "study/stop_signal.hpp"

#include <array>
#include <csignal>

namespace dashpad::app {

namespace {

constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> is_wanted = false;
std::atomic<int> caught = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void note(int signal) {
  caught = signal;
  is_wanted = true;
}

std::array<struct sigaction, stop_signals.size()> actions_before;

}  // namespace

StopSignal::StopSignal() {
  is_wanted = false;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  for (std::size_t i = 0; i < stop_signals.size(); ++i) {
    ::sigaction(stop_signals[i], nullptr, &actions_before[i]);
    // Whoever started this with nohup, or in the background of a script, wants it to go on.
    if (actions_before[i].sa_handler != SIG_IGN) ::sigaction(stop_signals[i], &action, nullptr);
  }
}

StopSignal::~StopSignal() {
  for (std::size_t i = 0; i < stop_signals.size(); ++i)
    ::sigaction(stop_signals[i], &actions_before[i], nullptr);
}

const std::atomic<bool>& StopSignal::wanted() { return is_wanted; }

int StopSignal::exit_code() { return 128 + caught; }

}  // namespace dashpad::app
