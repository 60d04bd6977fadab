#include "input/spelling.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace dashpad::input {
namespace {

constexpr std::size_t longest_word = 64;

/// The number of letters to insert, delete or replace.
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

/// What capitals and blanks are of no account in: "EN 1078" is "en-1078".
std::string folded(std::string_view word) {
  std::string plain(word);
  for (char& c : plain) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == ' ' || c == '_') c = '-';
  }
  return plain;
}

/// A single letter does not suggest a word.
constexpr std::size_t shortest_beginning = 2;

/// "a", "b" or "c".
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + ("\"" + words[i] + "\"");
  return text;
}

std::vector<std::string> beginning_with(std::string_view word, std::span<const std::string> words) {
  std::vector<std::string> found;
  if (word.size() < shortest_beginning) return found;
  std::ranges::copy_if(words, std::back_inserter(found),
                       [word](const std::string& candidate) { return folded(candidate).starts_with(word); });
  return found;
}

}  // namespace

std::string did_you_mean(std::string_view word, std::span<const std::string> words) {
  if (word.size() > longest_word) return {};
  const std::string plain = folded(word);
  if (const auto same = std::ranges::find(words, plain, folded); same != words.end())
    return "; did you mean \"" + *same + "\"?";
  if (const auto longer = beginning_with(plain, words); !longer.empty())
    return "; did you mean " + alternatives(longer) + "?";
  const std::string* closest = nullptr;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const std::size_t distance = edit_distance(plain, folded(candidate));
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

std::string short_listing(const std::vector<std::string>& words) {
  constexpr std::size_t most = 20;
  if (words.size() <= most) return listing(words);
  return listing(std::span(words).first(most)) + ", ...";
}

std::string meant_or_listed(std::string_view word, std::span<const std::string> words) {
  const std::string meant = did_you_mean(word, words);
  return meant.empty() ? "; available: " + listing(words) : meant;
}

std::vector<std::string> names_of(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : files) names.push_back(file.stem().string());
  return names;
}

std::string no_such(const std::string& kind, const std::string& name, const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files) {
  const std::vector<std::string> names = names_of(files);
  return "no such " + kind + " in " + folder.string() +
         "; available: " + (names.empty() ? "none" : listing(names)) + did_you_mean(name, names);
}

}  // namespace dashpad::input
