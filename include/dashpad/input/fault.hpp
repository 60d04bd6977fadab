#pragma once
/// What is wrong with something that a user gave us, said so that the user can mend it.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace dashpad::input {

/// A line of a file, and what is meant in it.
struct Excerpt {
  std::string line;        ///< as it stands there; "" where there is none to show
  std::size_t begin = 0;   ///< of what is meant, in bytes
  std::size_t length = 0;  ///< 0: the whole line
};

/// One fault: where it stands, what stands there, and the rule that it breaks.
struct Fault {
  std::string file;
  int line = 0;  ///< 0 where no line can be named
  std::string key;
  std::string value;  ///< as written
  std::string rule;   ///< what would be right, in the user's words
  Excerpt excerpt = {};
};

/// "case.toml:12: impactor.speed = \"20\": rule" - one line.
std::string to_string(const Fault& fault);

/// The same, and below it the line of the file with what is meant marked, where there is one.
std::string with_excerpt(const Fault& fault);

/// What is shown of many faults. Of more than five lines of one kind the first five, then "and 195 more of
/// this kind". Of one kind are lines that differ only in their numbers, in the value between " = " and the
/// last ": ", and in what stands below them.
std::vector<std::string> abridged(const std::vector<std::string>& lines);

/// Bad input. Carries every fault found, not only the first; what() has one fault a line, abridged.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// One fault: of the whole file, unless a line is named.
std::vector<Fault> fault_of_file(const std::filesystem::path& file, const std::string& rule, int line = 0);
/// Throws it as an InputError.
[[noreturn]] void refuse_file(const std::filesystem::path& file, const std::string& rule, int line = 0);

}  // namespace dashpad::input
