#pragma once
/// The question of `dashpad solve-for`, as the command line asks it.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "dashpad/margin/margin.hpp"
#include "output_files.hpp"

namespace dashpad::app {

struct SolveForRequest {
  std::string key;
  GivenCase given;
  std::vector<std::string> standards, until, vary;
  std::optional<std::string> between, probability, tolerance;
  std::optional<std::uint64_t> draws, seed;
  std::string standard_folder;
  OutputFiles files;
  bool no_intervals = false;
};

/// Reads the case, standards and limits. Throws Refused with all errors.
margin::Question question_of(const SolveForRequest& request);

/// Calls margin::solve_for() with a progress line on standard error.
margin::Answer solve_for_with_progress(const margin::Question& question);

}  // namespace dashpad::app
