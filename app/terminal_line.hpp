#pragma once
/// A line of standard error that is drawn again and again, where that is a terminal.

#include <cstddef>
#include <cstdint>
#include <string>

namespace dashpad::app {

class TerminalLine {
 public:
  TerminalLine();
  /// Wipes the line.
  ~TerminalLine();
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  /// Whether standard error is a terminal; draw() is only for one.
  [[nodiscard]] bool is_terminal() const { return terminal_; }
  /// In the place of what was drawn before.
  void draw(const std::string& line);
  /// Leaves an empty line, for other text.
  void wipe();

 private:
  bool terminal_ = false;
  std::string drawn_;
  std::size_t width_ = 0;  ///< of the longest line so far
};

/// `done` of `all` in thirty characters: "######........................"; full if there is nothing to do.
std::string progress_bar(std::uint64_t done, std::uint64_t all);

}  // namespace dashpad::app
