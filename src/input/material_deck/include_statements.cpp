#include "input/material_deck/include_statements.hpp"

#include <algorithm>
#include <utility>

#include "input/material_deck/abaqus.hpp"
#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

bool begins_with_word(std::string_view line, std::string_view word) {
  return line.size() >= word.size() && std::ranges::equal(line.substr(0, word.size()), word, {}, [](char c) {
           return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
         });
}

bool is_word(std::string_view line, std::string_view word) {
  const std::string_view text = without_blanks(line);
  return text.size() == word.size() && begins_with_word(text, word);
}

IncludeStatements::Found IncludeStatements::in(std::string_view line) {
  constexpr std::string_view keyword = "*INCLUDE", radioss = "#INCLUDE";
  if (!begun_keyword_.empty()) return with_parameters(line);
  // Keywords and encrypted parts are no names.
  if (names_follow_ && !line.starts_with('*') && !line.starts_with("-----")) return named_below(line);
  names_follow_ = is_word(line, keyword);
  begun_name_.clear();
  if (names_follow_) return {.is_part = true};
  if (begins_with_word(line, radioss) && line.size() > radioss.size() &&
      (line[radioss.size()] == ' ' || line[radioss.size()] == '\t'))
    return {.is_part = true, .name = unquoted(line.substr(radioss.size()))};
  const std::string_view text = without_blanks(line);
  const auto comma = text.find(',');
  if (comma != std::string_view::npos && is_word(text.substr(0, comma), keyword))
    return with_parameters(text);
  return {};
}

IncludeStatements::Found IncludeStatements::named_below(std::string_view line) {
  const std::string_view text = without_blanks(line);
  if (text.empty() || text.starts_with('$')) return {.is_part = true};
  if (text.ends_with(" +")) {
    begun_name_ += without_blanks(text.substr(0, text.size() - 1));
    return {.is_part = true};
  }
  return {.is_part = true, .name = std::exchange(begun_name_, {}) + std::string(text)};
}

IncludeStatements::Found IncludeStatements::with_parameters(std::string_view line) {
  begun_keyword_ += without_blanks(line);
  if (begun_keyword_.ends_with(',')) return {.is_part = true};
  const AbaqusKeyword keyword = abaqus_keyword(std::exchange(begun_keyword_, {}), 0);
  const auto input = keyword.parameters.find("INPUT");
  return {.is_part = true,
          .name = unquoted(input == keyword.parameters.end() ? "" : input->second),
          .has_password = keyword.parameters.contains("PASSWORD")};
}

}  // namespace dashpad::input
