#pragma once
/// Anybody's text on its way into a picture.

#include <cstddef>
#include <string>
#include <string_view>

namespace dashpad::output {

/// Valid UTF-8 in one line: control characters become spaces, bytes that are not UTF-8 "�".
std::string readable(std::string_view text);

/// `text`, readable, and at most `length` characters long. Where it is cut it ends with "…".
std::string shortened(std::string_view text, std::size_t length);

}  // namespace dashpad::output
