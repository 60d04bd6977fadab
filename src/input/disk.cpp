#include "input/disk.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace dashpad::input {
namespace {

/// Why a file is not regular; "" if it is.
std::string why_not_regular(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return "no such file";
  if (error) return "cannot be read: " + error.message();
  if (is_directory(status)) return "is a folder; a file is needed";
  return is_regular_file(status) ? "" : "is not a regular file";
}

}  // namespace

bool is_link(const std::filesystem::path& file) {
  std::error_code none;
  return std::filesystem::is_symlink(file, none);
}

bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other) {
  std::error_code ignored;
  return std::filesystem::equivalent(file, other, ignored);
}

bool is_there(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

Reading<std::string> content_of(const std::filesystem::path& file, std::size_t most) {
  if (const std::string why = why_not_regular(file); !why.empty()) return fault_of_file(file, why);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fault_of_file(file, std::string("cannot be read: ") + std::strerror(errno));
  // Reads little more than is allowed, since some files grow while they are read.
  std::string content;
  std::array<char, 16384> piece;
  while (content.size() <= most && stream) {
    stream.read(piece.data(), piece.size());
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return fault_of_file(file, "cannot be read to the end");
  return content;
}

Reading<std::vector<std::filesystem::path>> toml_files(const std::filesystem::path& folder,
                                                       std::string_view content) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".toml" && entry->is_regular_file()) files.push_back(entry->path());
  if (error)
    return fault_of_file(folder,
                         "is not a readable folder of " + std::string(content) + ": " + error.message());
  std::ranges::sort(files);
  return files;
}

}  // namespace dashpad::input
