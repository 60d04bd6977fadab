#pragma once
/// How the command ends, the native one and that of the package for npm.

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/margin/margin.hpp"

namespace dashpad::live {

enum ExitCode {
  exit_done = 0,         ///< results are there; also when the pad bottomed out or the time limit was reached
  exit_failed = 1,       ///< a result could not be written, or the program is at fault
  exit_refused = 2,      ///< input or command line refused; nothing was run and nothing written
  exit_not_trusted = 3,  ///< no verdict, or not reliable: results are there, but miss the tolerance
  exit_not_passed = 4,   ///< a standard's limit is exceeded, or a rule of the validation is missed
};

/// The exit code of a solved impact. A pad that bottomed out on a rigid support is a result, even if the
/// tolerance was missed before.
ExitCode exit_code(const Summary& summary);
/// The exit code of a verdict about an impact: a failure takes precedence over a missed tolerance. Of several
/// verdicts the greatest code counts.
ExitCode exit_code(injury::Verdict verdict, const Summary& summary);
/// The exit code of a verdict about measured figures.
ExitCode exit_code(injury::Verdict verdict);
/// The exit code of a search.
ExitCode exit_code(const margin::Answer& answer);

}  // namespace dashpad::live
