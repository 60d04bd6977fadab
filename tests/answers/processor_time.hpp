#pragma once
/// Time of the processor: that of a shared machine's clock says little.

#include <ctime>

namespace dashpad::test {

/// Of this thread, s.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace dashpad::test
