#include "progress_line.hpp"

#include <utility>

#include <fmt/format.h>

namespace dashpad {

ProgressLine::ProgressLine(std::string what) : what_(std::move(what)) {}

void ProgressLine::show(std::size_t done, std::size_t all) {
  if (!line_.is_terminal() || all == 0) return;
  const std::string line = fmt::format("{} [{}] {:3} %", what_, progress_bar(done, all), 100 * done / all);
  const std::lock_guard lock{mutex_};
  line_.draw(line);
}

}  // namespace dashpad
