#include "study/progress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "streams.hpp"

namespace dashpad::app {

namespace {

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

}  // namespace

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

}  // namespace dashpad::app
