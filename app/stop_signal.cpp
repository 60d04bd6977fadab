#include "stop_signal.hpp"

#include <array>
#include <csignal>

namespace dashpad {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> is_wanted = false;
std::atomic<int> number = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void note(int signal) {
  number = signal;
  is_wanted = true;
}

void handle(void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  for (const int signal : signals) ::sigaction(signal, &action, nullptr);
}

}  // namespace

StopSignal::StopSignal() {
  is_wanted = false;
  handle(note, static_cast<int>(SA_RESTART | SA_RESETHAND));
}

StopSignal::~StopSignal() { handle(SIG_DFL, 0); }

const std::atomic<bool>& StopSignal::wanted() { return is_wanted; }

int StopSignal::exit_code() { return 128 + number; }

}  // namespace dashpad
