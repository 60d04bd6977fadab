#pragma once
/// Statements that include a file in a deck.

#include <optional>
#include <string>
#include <string_view>

namespace dashpad::input {

/// Finds the names of included files in the lines of a file, which are given one after the other.
class IncludeStatements {
 public:
  struct Found {
    bool is_part = false;               ///< of a statement: the line holds nothing else
    std::optional<std::string> name{};  ///< where the name of a file ends
    bool has_password = false;
  };
  Found in(std::string_view line);

 private:
  Found named_below(std::string_view line);
  Found with_parameters(std::string_view line);

  bool names_follow_ = false;  ///< LS-DYNA names the files in the lines below
  std::string begun_name_;     ///< a name that goes on in the next line
  std::string begun_keyword_;  ///< a keyword of Abaqus that goes on in the next line
};

/// Whether the line is the word, in capitals or not, with or without blanks around it.
bool is_word(std::string_view line, std::string_view word);
/// Whether the line begins with the word, in capitals or not.
bool begins_with_word(std::string_view line, std::string_view word);

}  // namespace dashpad::input
