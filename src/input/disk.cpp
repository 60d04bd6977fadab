#include "input/disk.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "dashpad/input/fault.hpp"

namespace dashpad::input {
namespace {

void require_regular(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse_file(file, "no such file");
  if (error) refuse_file(file, "cannot be read: " + error.message());
  if (is_directory(status)) refuse_file(file, "is a folder; a file is needed");
  if (!is_regular_file(status)) refuse_file(file, "is not a regular file");
}

}  // namespace

bool is_there(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

std::string content_of(const std::filesystem::path& file, std::size_t most) {
  require_regular(file);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file(file, std::string("cannot be read: ") + std::strerror(errno));
  // No more than a piece beyond what is allowed, whatever the file system says of the size: some files grow
  // while they are read.
  std::string content;
  std::array<char, 16384> piece;
  while (content.size() <= most && stream) {
    stream.read(piece.data(), piece.size());
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) refuse_file(file, "cannot be read to its end");
  return content;
}

std::vector<std::filesystem::path> toml_files(const std::filesystem::path& folder, std::string_view of) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".toml" && entry->is_regular_file()) files.push_back(entry->path());
  if (error)
    throw InputError({Fault{folder.string(), 0, "", "",
                            "is not a readable folder of " + std::string(of) + ": " + error.message()}});
  std::ranges::sort(files);
  return files;
}

}  // namespace dashpad::input
