// Small text files, and streams in their place.

#include "input/disk.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "dashpad/input/fault.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

namespace {

constexpr const char* standard_input = "-";

std::map<std::filesystem::path, std::string>& taken() {
  static std::map<std::filesystem::path, std::string> streams;
  return streams;
}

bool is_pipe(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

std::string read_to_end(int descriptor, const std::filesystem::path& file) {
  std::string content = read_bytes(descriptor, file.string(), largest_stream + 1);
  if (content.size() > largest_stream)
    refuse_file(file, fmt::format("is larger than {} MiB, the limit for a pipe", largest_stream >> 20));
  return content;
}

constexpr std::size_t largest_size = 1024 * 1024;  // bytes

Reading<std::string> text_of(const std::filesystem::path& file, std::string content) {
  if (content.size() > largest_size) return fault_of_file(file, "is larger than 1 MiB");
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff"))
    return fault_of_file(file, "is UTF-16; save it as UTF-8", 1);
  const auto nul = content.find('\0');
  if (nul == std::string::npos) return content;
  const auto lines = std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  return fault_of_file(file, "is not text: it contains a NUL byte", static_cast<int>(lines) + 1);
}

}  // namespace

void take_given_stream(const std::filesystem::path& file) {
  if (file == standard_input) {
    if (given_stream(file) != nullptr) refuse_file(file, "standard input can be read only once");
    taken()[file] = read_to_end(STDIN_FILENO, file);
  } else if (is_pipe(file) && given_stream(file) == nullptr) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) refuse_file(file, std::string("cannot be read: ") + std::strerror(errno));
    taken()[file] = read_to_end(descriptor, file);
    ::close(descriptor);
  }
}

const std::string* given_stream(const std::filesystem::path& file) {
  const auto found = taken().find(file);
  return found == taken().end() ? nullptr : &found->second;
}

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

Reading<std::string> read_text_file(const std::filesystem::path& file) {
  if (const std::string* given = given_stream(file)) return text_of(file, *given);
  Reading<std::string> content = content_of(file, largest_size);
  return content ? text_of(file, *std::move(content)) : content;
}

}  // namespace dashpad::input
