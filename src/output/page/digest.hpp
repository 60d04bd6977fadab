#pragma once
/// What a policy of content knows a script or a style by.

#include <string>
#include <string_view>

namespace dashpad::output {

/// "sha256-" and the SHA-256 of the text in Base64, as a Content-Security-Policy writes it.
std::string policy_hash(std::string_view text);

}  // namespace dashpad::output
