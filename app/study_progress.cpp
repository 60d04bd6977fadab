#include "study_progress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "streams.hpp"

namespace dashpad {

namespace {

constexpr double between_drawings = 0.2, first_line = 10, between_lines = 60;  // s

std::string bar(std::uint64_t done, std::uint64_t all) {
  constexpr std::uint64_t width = 30;
  const auto filled = static_cast<std::size_t>(all == 0 ? width : width * done / all);
  return std::string(filled, '#') + std::string(width - filled, '.');
}

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

StudyProgress::StudyProgress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {
  if (!terminal_) next_ = first_line;
}

StudyProgress::~StudyProgress() {
  if (width_ > 0) write_error("\r" + std::string(width_, ' ') + "\r");
}

void StudyProgress::show(const study::Progress& progress) {
  if (quiet_ || progress.seconds < next_) return;
  if (!terminal_) {
    next_ = progress.seconds + between_lines;
    write_error(words(progress) + "\n");
    return;
  }
  next_ = progress.seconds + between_drawings;
  std::string line = fmt::format("[{}] {}", bar(progress.rows_done, progress.rows), words(progress));
  const std::size_t length = line.size();
  if (length < width_) line += std::string(width_ - length, ' ');
  width_ = std::max(width_, length);
  write_error("\r" + line);
}

}  // namespace dashpad
