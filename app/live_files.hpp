#pragma once
/// What a live page is made of, for `dashpad explore` and `dashpad assess --live`.

#include <string>
#include <vector>

#include "command.hpp"

namespace dashpad::app {

/// The engine; an error if it is missing.
std::string read_engine(std::vector<std::string>& errors);

/// The case as it is written, if all that it names is in the page, too; else as computed, in SI, with its
/// law.
std::string live_case_text(const GivenCase& request, const input::CaseFile& given);

/// An error for a standard that is a file of the user.
void check_live_standard(const char* option, const std::string& name, std::vector<std::string>& errors);

}  // namespace dashpad::app
