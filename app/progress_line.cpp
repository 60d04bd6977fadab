#include "progress_line.hpp"

#include <algorithm>
#include <array>
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
constexpr double worth_saying = 60;                          // s
constexpr std::array<double, 3> times_of_lines{10, 30, 60};  ///< after the first, s

}  // namespace

ProgressLine::ProgressLine(std::string what, Elsewhere elsewhere)
    : what_(std::move(what)),
      elsewhere_(elsewhere),
      next_line_(std::chrono::duration<double>(silence).count()),
      clock_([this](const std::stop_token& stop) { tick(stop); }) {}

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
    if (line_.is_terminal())
      draw(seconds);
    else if (elsewhere_ == Elsewhere::lines)
      add_line(seconds);
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

void ProgressLine::add_line(double seconds) {
  if (seconds < next_line_) return;
  const auto after = std::ranges::upper_bound(times_of_lines, seconds);
  next_line_ =
      after != times_of_lines.end() ? *after : (std::floor(seconds / worth_saying) + 1) * worth_saying;
  write_error(seconds < 2 * worth_saying
                  ? fmt::format("{}, {:.0f} s\n", what_, std::floor(seconds))
                  : fmt::format("{}, {:.0f} min\n", what_, std::floor(seconds / worth_saying)));
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
