#pragma once
/// How far a study is, with its rate and the time left, on standard error: a line that is drawn again on a
/// terminal, a line now and then elsewhere.

#include <cstddef>
#include <string>

#include "dashpad/study/run_study.hpp"

namespace dashpad {

class StudyProgress {
 public:
  explicit StudyProgress(bool quiet);
  /// Wipes the line of a terminal.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  void show(const study::Progress& progress);

 private:
  bool quiet_ = false;
  bool terminal_ = false;
  double next_ = 0;  ///< s, when something is shown again
  std::size_t width_ = 0;
};

/// "1:02:03", "2:03" or "12 s".
std::string clock_text(double seconds);
/// "812 rows/s", "12.3 thousand rows/s".
std::string rate_text(double rows, double seconds);

}  // namespace dashpad
