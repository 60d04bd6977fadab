#pragma once
/// Suggestions for misspelt names.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dashpad::input {

/// `; did you mean "radius"?`, with the word that differs in capitals and blanks only, or else all words that
/// begin with `word`, or else the closest one, if any.
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

std::string listing(std::span<const std::string> words);

/// The first twenty words, comma separated.
std::string short_listing(const std::vector<std::string>& words);

/// did_you_mean(), or else "; available: radius, mass".
std::string meant_or_listed(std::string_view word, std::span<const std::string> words);

/// The names of files without their extensions.
std::vector<std::string> names_of(const std::vector<std::filesystem::path>& files);

/// The rule for an unknown name in a folder: "no such card in materials; available: vn600".
std::string no_such(const std::string& kind, const std::string& name, const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files);

}  // namespace dashpad::input
