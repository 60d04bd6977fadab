#pragma once
/// What a user may have meant.

#include <span>
#include <string>
#include <string_view>

namespace dashpad::input {

/// `; did you mean "radius"?` for the words that begin with `word`, all of them, or else for the closest one;
/// "" if none is close.
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

/// The words, comma separated.
std::string listing(std::span<const std::string> words);

}  // namespace dashpad::input
