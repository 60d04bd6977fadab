#pragma once
/// Responses and limits as the user names them.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/study/questions.hpp"

namespace dashpad::app {

/// Why the store has no such response; empty if it has.
std::string response_rule(const std::string& name, const study::Store& store);

/// "hic15 > 1000", "peak_force = 5 kN". Absent after a complaint.
std::optional<study::StudyLimit> limit_of(const std::string& text, const study::Store& store,
                                          std::vector<std::string>& wrong);

}  // namespace dashpad::app
