#include "input/text_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "dashpad/input/fault.hpp"
#include "input/given_stream.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t largest_size = 1024 * 1024;  // bytes

void require_regular(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse_file(file, "no such file");
  if (error) refuse_file(file, "cannot be read: " + error.message());
  if (is_directory(status)) refuse_file(file, "is a folder; a file is needed");
  if (!is_regular_file(status)) refuse_file(file, "is not a regular file");
}

void require_text(const std::filesystem::path& file, const std::string& content) {
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff"))
    refuse_file(file, "is UTF-16; save it as UTF-8", 1);
  const auto nul = content.find('\0');
  if (nul == std::string::npos) return;
  const auto lines = std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  refuse_file(file, "is not text: it holds a NUL byte", static_cast<int>(lines) + 1);
}

}  // namespace

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

std::string read_text_file(const std::filesystem::path& file) {
  if (const std::string* given = given_stream(file)) {
    if (given->size() > largest_size) refuse_file(file, "is larger than 1 MiB");
    require_text(file, *given);
    return *given;
  }
  require_regular(file);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file(file, std::string("cannot be read: ") + std::strerror(errno));
  // No more than a piece beyond what is allowed, whatever the file system says of the size: some files grow
  // while they are read.
  std::string content;
  std::array<char, 16384> piece;
  while (content.size() <= largest_size && stream) {
    stream.read(piece.data(), piece.size());
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) refuse_file(file, "cannot be read to its end");
  if (content.size() > largest_size) refuse_file(file, "is larger than 1 MiB");
  require_text(file, content);
  return content;
}

}  // namespace dashpad::input
