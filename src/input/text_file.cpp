#include "input/text_file.hpp"

#include <algorithm>

#include "input/disk.hpp"
#include "input/given_stream.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t largest_size = 1024 * 1024;  // bytes

Reading<std::string> text_of(const std::filesystem::path& file, std::string content) {
  if (content.size() > largest_size) return fault_of_file(file, "is larger than 1 MiB");
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff"))
    return fault_of_file(file, "is UTF-16; save it as UTF-8", 1);
  const auto nul = content.find('\0');
  if (nul == std::string::npos) return content;
  const auto lines = std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  return fault_of_file(file, "is not text: it holds a NUL byte", static_cast<int>(lines) + 1);
}

}  // namespace

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
