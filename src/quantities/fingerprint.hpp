#pragma once
/// Tells texts from others that were changed, by accident or by hand.

#include <string>
#include <vector>

namespace dashpad {

/// FNV-1a of the texts and of where each ends: 16 hexadecimal digits.
std::string fingerprint(const std::vector<std::string>& texts);

}  // namespace dashpad
