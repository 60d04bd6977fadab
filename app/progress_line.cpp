#include "progress_line.hpp"

#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "streams.hpp"

namespace dashpad {

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (!shown_.empty()) write_error("\r" + std::string(shown_.size(), ' ') + "\r");
}

void ProgressLine::show(std::size_t done, std::size_t all) {
  if (!terminal_ || all == 0) return;
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done / all;
  const std::string line = fmt::format("{} [{}{}] {:3} %", what_, std::string(filled, '#'),
                                       std::string(width - filled, '.'), 100 * done / all);
  const std::lock_guard lock{mutex_};
  if (line == shown_) return;
  shown_ = line;
  write_error("\r" + line);
}

}  // namespace dashpad
