#pragma once
/// How far a study is, with its rate and the time left, on standard error: a line that is drawn again on a
/// terminal, a line now and then elsewhere.

#include <string>

#include "dashpad/study/run_study.hpp"
#include "terminal_line.hpp"

namespace dashpad::app {

class StudyProgress {
 public:
  explicit StudyProgress(bool quiet);

  void show(const study::Progress& progress);

 private:
  bool quiet_ = false;
  TerminalLine line_;
  double next_ = 0;  ///< s, when something is shown again
};

/// "1:02:03", "2:03" or "12 s".
std::string clock_text(double seconds);
/// "812 rows/s", "12.3 thousand rows/s".
std::string rate_text(double rows, double seconds);

}  // namespace dashpad::app
