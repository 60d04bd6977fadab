#pragma once
/// A program run as a user runs it, and what it cost.

#include <string>
#include <vector>

namespace dashpad::bench {

struct ProcessCost {
  int exit_code = -1;
  double wall = 0;         ///< s
  double cpu = 0;          ///< s, user and system, its own processes included
  double peak_memory = 0;  ///< resident, bytes; of the largest process
};

/// The first argument is the program, sought in PATH. Its output goes nowhere. Throws std::runtime_error if
/// it cannot be started or is killed.
ProcessCost timed_process(const std::vector<std::string>& arguments);

}  // namespace dashpad::bench
