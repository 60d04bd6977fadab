#include "waiting_line.hpp"

#include <utility>

#include <fmt/format.h>

#include "study_progress.hpp"

namespace dashpad {

namespace {

using namespace std::chrono_literals;
constexpr std::chrono::milliseconds until_first = 1s, between_drawings = 200ms;

}  // namespace

WaitingLine::WaitingLine(std::string what) : what_(std::move(what)) {
  if (line_.is_terminal()) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void WaitingLine::now(std::string what) {
  const std::lock_guard lock{mutex_};
  what_ = std::move(what);
}

void WaitingLine::run(const std::stop_token& stop) {
  std::unique_lock lock{mutex_};
  wake_.wait_for(lock, stop, until_first, [] { return false; });
  while (!stop.stop_requested()) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin_;
    line_.draw(fmt::format("{} ... {}", what_, clock_text(seconds.count())));
    wake_.wait_for(lock, stop, between_drawings, [] { return false; });
  }
}

}  // namespace dashpad
