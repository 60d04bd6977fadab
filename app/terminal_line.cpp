#include "terminal_line.hpp"

#include <algorithm>

#include <unistd.h>

#include "streams.hpp"

namespace dashpad::app {

TerminalLine::TerminalLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

TerminalLine::~TerminalLine() { wipe(); }

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

}  // namespace dashpad::app
