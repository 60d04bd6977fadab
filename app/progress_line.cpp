#include "progress_line.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "output.hpp"

namespace dashpad::app {

TerminalLine::TerminalLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

void TerminalLine::wipe() {
  if (width_ > 0) write_all(STDERR_FILENO, "\r" + std::string(width_, ' ') + "\r");
  drawn_.clear();
  width_ = 0;
}

void TerminalLine::draw(const std::string& line) {
  if (line == drawn_) return;
  drawn_ = line;
  width_ = std::max(width_, line.size());
  write_all(STDERR_FILENO, "\r" + line + std::string(width_ - line.size(), ' '));
}

std::string progress_bar(std::uint64_t done, std::uint64_t all) {
  constexpr std::uint64_t width = 30;
  const std::uint64_t filled = all == 0 ? width : width * done / all;
  return std::string(filled, '#') + std::string(width - filled, '.');
}

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto silence = 1s;
constexpr auto between_drawings = 200ms;
/// Earlier, s, the share done does not predict the rest.
constexpr double enough_to_tell = 2;
constexpr double worth_saying = 60;                          // s
constexpr std::array<double, 3> times_of_lines{10, 30, 60};  ///< after the first, s

constexpr double between_updates = 0.2, first_line = 10, between_lines = 60;  // s

std::string words(const study::Progress& progress) {
  const auto now = static_cast<double>(progress.rows_done - progress.rows_before);
  const auto left = static_cast<double>(progress.rows - progress.rows_done);
  std::string text = fmt::format("{} of {} rows", progress.rows_done, progress.rows);
  if (now > 0 && progress.seconds > 0)
    text += fmt::format(", {}, {} left", rate_text(now, progress.seconds),
                        clock_text(left * progress.seconds / now));
  return text;
}

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

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::min(seconds, 1e15)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string rate_text(double rows, double seconds) {
  const double rate = seconds > 0 ? rows / seconds : 0;
  if (rate >= 1e4) return fmt::format("{:.3g} thousand rows/s", std::min(rate / 1000, 999e6));
  return rate >= 100 ? fmt::format("{:.0f} rows/s", rate) : fmt::format("{:.3g} rows/s", rate);
}

StudyProgress::StudyProgress(bool quiet) : quiet_(quiet) {
  if (!line_.is_terminal()) next_ = first_line;
}

void StudyProgress::show(const study::Progress& progress) {
  if (quiet_ || progress.seconds < next_) return;
  if (line_.is_terminal()) {
    next_ = progress.seconds + between_updates;
    line_.draw(fmt::format("[{}] {}", progress_bar(progress.rows_done, progress.rows), words(progress)));
  } else {
    next_ = progress.seconds + between_lines;
    write_error(words(progress) + "\n");
  }
}

StopSignal::StopSignal() {
  is_wanted = false;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  for (std::size_t i = 0; i < stop_signals.size(); ++i) {
    ::sigaction(stop_signals[i], nullptr, &actions_before[i]);
    // With nohup, or in the background of a script, a signal that is ignored stays so.
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
