#pragma once
/// Names at the beginning and in the middle of a sentence.

#include <string>

namespace dashpad::output {

/// Capitalises words for the beginning of a label.
inline std::string capitalised(std::string words) {
  if (!words.empty() && words.front() >= 'a' && words.front() <= 'z') words.front() += 'A' - 'a';
  return words;
}

/// Removes the capital for the middle of a sentence: "peak force", but "HIC15".
inline std::string uncapitalised(std::string words) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (words.size() > 1 && is_capital(words[0]) && !is_capital(words[1])) words.front() += 'a' - 'A';
  return words;
}

}  // namespace dashpad::output
