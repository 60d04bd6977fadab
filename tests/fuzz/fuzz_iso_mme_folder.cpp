// Tests in ISO-MME in a folder. The input is all of its files: a line "=== NAME" begins each.

#include <algorithm>
#include <cstdint>

#include "iso_mme_test.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad::fuzz;

namespace {

constexpr std::string_view mark = "=== ";

bool is_plain(std::string_view name) {
  const auto is_harmless = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '/' || c == '_';
  };
  return !name.empty() && name.size() < 100 && name.front() != '/' && name.back() != '/' &&
         name.find("..") == std::string_view::npos && std::ranges::all_of(name, is_harmless);
}

/// False where a name is none for a file, or that of a folder, too.
bool unpack(std::string_view input) {
  while (input.starts_with(mark)) {
    const auto line_end = std::min(input.find('\n'), input.size());
    const std::string_view name = input.substr(mark.size(), line_end - std::min(mark.size(), line_end));
    input.remove_prefix(std::min(line_end + 1, input.size()));
    const auto next = input.starts_with(mark) ? 0 : input.find("\n=== ");
    const std::string_view content =
        input.substr(0, next == 0 || next == std::string_view::npos ? next : next + 1);
    if (!is_plain(name)) return false;
    try {
      write("test" / fs::path(name), content);
    } catch (const std::exception&) {
      return false;
    }
    input.remove_prefix(content.size());
  }
  return input.empty();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  fs::remove_all(folder() / "test");
  fs::create_directories(folder() / "test");
  if (unpack(text_of(bytes, size))) read_iso_mme_test(folder() / "test");
  return 0;
}
