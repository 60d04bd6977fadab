#include "io/spelling.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace dashpad {
namespace {

constexpr std::size_t longest_word = 64;

/// Letters to insert, delete or replace to make one word of the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : from) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (letter != to[j] ? 1 : 0);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(std::string_view word, std::span<const std::string> words) {
  if (word.size() > longest_word) return {};
  const std::string* closest = nullptr;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= least || distance >= std::min(word.size(), candidate.size())) continue;
    least = distance;
    closest = &candidate;
  }
  return closest ? "; did you mean \"" + *closest + "\"?" : "";
}

std::string listing(std::span<const std::string> words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace dashpad
