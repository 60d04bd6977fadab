#pragma once
/// Faults in input, worded so that users can correct them.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace dashpad::input {

/// A line of a file with a marked part.
struct Excerpt {
  std::string line;        ///< empty if there is none to show
  std::size_t begin = 0;   ///< of the marked part, in bytes
  std::size_t length = 0;  ///< 0 for the whole line
};

/// A fault: its place, the value found there, and the rule that it breaks.
struct Fault {
  std::string file;
  int line = 0;  ///< 0 if unknown
  std::string key;
  std::string value;  ///< as written
  std::string rule;   ///< what would be right, in terms of the user
  Excerpt excerpt = {};
};

/// "case.toml:12: impactor.speed = \"20\": rule", in one line.
std::string to_string(const Fault& fault);

/// The same text, followed by the line of the file with the marked part, if there is one.
std::string with_excerpt(const Fault& fault);

/// Shortens a list of faults: of more than five lines of one kind, the first five and "and 195 more of this
/// kind". Lines of one kind differ only in numbers, in the value between " = " and the last ": ", and in what
/// follows the first line.
std::vector<std::string> abridged(const std::vector<std::string>& lines);

/// Thrown for bad input, with all faults; what() has one line per fault, abridged.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A single fault of a file, with or without a line.
std::vector<Fault> fault_of_file(const std::filesystem::path& file, const std::string& rule, int line = 0);
/// Throws an InputError with a single fault.
[[noreturn]] void refuse_file(const std::filesystem::path& file, const std::string& rule, int line = 0);

}  // namespace dashpad::input
