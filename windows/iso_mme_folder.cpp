// ISO-MME tests in a folder, in place of src/input/iso_mme/folder.cpp, which goes from folder to folder by
// system calls of POSIX.

#include <system_error>

#include <fcntl.h>

#include "input/iso_mme/test_files.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_names = 100'000;

/// Adds the files; returns the folders called Channel, ignoring case.
std::vector<std::string> list(const fs::path& folder, const std::string& prefix,
                              std::vector<std::string>& names) {
  std::vector<std::string> channel_folders;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->is_regular_file(error)) names.push_back(prefix + name);
    if (lower_case(name) == "channel" && entry->is_directory(error)) channel_folders.push_back(name);
    if (names.size() > max_names) break;
  }
  if (error) refuse_file(folder, "cannot be read: " + error.message());
  return channel_folders;
}

}  // namespace

std::vector<std::string> names_in_folder(const fs::path& folder) {
  std::vector<std::string> names;
  for (const std::string& name : list(folder, "", names)) list(folder / name, name + "/", names);
  if (names.size() > max_names) refuse_file(folder, "contains too many files");
  return names;
}

MmeMembers read_from_folder(const fs::path& folder, const std::vector<std::string>& names, std::size_t most,
                            bool cut) {
  MmeMembers members;
  for (const std::string& name : names) {
    const fs::path file = folder / name;
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) refuse_file(file, "cannot be read");
    members[name] = read_descriptor(descriptor, file.string(), most, cut);
  }
  return members;
}

}  // namespace dashpad::input
