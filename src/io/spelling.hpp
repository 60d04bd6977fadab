#pragma once
/// What a user may have meant.

#include <span>
#include <string>
#include <string_view>

namespace dashpad {

/// `; did you mean "radius"?` if one of the words is close to `word`; otherwise "".
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

/// The words, comma separated.
std::string listing(std::span<const std::string> words);

}  // namespace dashpad
