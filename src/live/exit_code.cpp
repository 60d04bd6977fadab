#include "live/exit_code.hpp"

#include <algorithm>

namespace dashpad::live {

ExitCode exit_code(const Summary& summary) {
  return summary.trustworthy() || bottomed_on_rigid_support(summary) ? exit_done : exit_not_trusted;
}

ExitCode exit_code(injury::Verdict verdict) {
  switch (verdict) {
    case injury::Verdict::fail: return exit_not_passed;
    case injury::Verdict::undecided: return exit_not_trusted;
    case injury::Verdict::pass: break;
  }
  return exit_done;
}

ExitCode exit_code(injury::Verdict verdict, const Summary& summary) {
  return verdict == injury::Verdict::pass ? exit_code(summary) : exit_code(verdict);
}

ExitCode exit_code(const margin::Answer& answer) {
  const auto any = [&](margin::Zone zone) {
    return std::ranges::find(answer.stretches, zone, &margin::Stretch::zone) != answer.stretches.end();
  };
  if (!answer.is_complete || answer.doubtful > 0) return exit_not_trusted;
  if (margin::is_aim(answer.question))
    return std::ranges::any_of(answer.turns, [](const margin::Turn& turn) { return !turn.jumps; })
               ? exit_done
               : exit_not_passed;
  if (any(margin::Zone::pass)) return exit_done;
  return any(margin::Zone::undecided) || any(margin::Zone::unknown) ? exit_not_trusted : exit_not_passed;
}

}  // namespace dashpad::live
