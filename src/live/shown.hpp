#pragma once
/// Answers that solve nothing: how a case is read, and the cards and standards there are.

#include "json/json_values.hpp"
#include "live/answer.hpp"

namespace dashpad::live {

Json check_case(const Json& request, const Folders& folders);
Json show_materials(const Json& request, const Folders& folders);
Json show_standards(const Json& request, const Folders& folders);

}  // namespace dashpad::live
