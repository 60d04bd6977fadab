#include "progress_line.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "streams.hpp"

namespace dashpad::app {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto silence = 1s;
constexpr auto between_drawings = 200ms;
/// The first share of a computation is no measure of the rest before this time, s.
constexpr double enough_to_tell = 2;
constexpr double worth_saying = 60;  // s

}  // namespace

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), clock_([this](const std::stop_token& stop) { tick(stop); }) {}

ProgressLine::~ProgressLine() {
  clock_.request_stop();
  clock_.join();  // before the line is wiped
}

void ProgressLine::show(std::size_t done, std::size_t all) {
  if (all > 0) share_ = static_cast<double>(done) / static_cast<double>(all);
}

void ProgressLine::expect(double seconds) {
  const std::lock_guard lock{mutex_};
  say(seconds);
}

void ProgressLine::now(std::string what) {
  const std::lock_guard lock{mutex_};
  what_ = std::move(what);
}

void ProgressLine::tick(const std::stop_token& stop) {
  const Clock::time_point begin = Clock::now();
  std::unique_lock lock{mutex_};
  Clock::duration pause = silence;
  while (!wake_.wait_for(lock, stop, pause, [&] { return stop.stop_requested(); })) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    say_how_long(seconds);
    if (line_.is_terminal()) draw(seconds);
    pause = between_drawings;
  }
}

void ProgressLine::draw(double seconds) {
  constexpr std::uint64_t whole = 100;
  const auto percent = static_cast<std::uint64_t>(std::floor(whole * std::min(share_.load(), 1.0)));
  const std::string bar =
      percent > 0 ? fmt::format(" [{}] {:3} %", progress_bar(percent, whole), percent) : std::string{};
  line_.draw(fmt::format("{}{}  {:.0f} s", what_, bar, std::floor(seconds)));
}

void ProgressLine::say_how_long(double seconds) {
  const double share = share_;
  if (said_how_long_ || seconds < enough_to_tell || share <= 0) return;
  say(seconds / share);
}

void ProgressLine::say(double seconds) {
  said_how_long_ = true;
  if (seconds < worth_saying) return;
  line_.wipe();
  write_error(fmt::format("{} will take about {:.0f} minutes\n", what_, std::ceil(seconds / 60)));
}

}  // namespace dashpad::app
