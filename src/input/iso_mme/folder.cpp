// Reads ISO-MME tests in a folder. Each step is by one name in one open folder, so that no link is followed
// and no name leads elsewhere.

#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input/iso_mme/test_files.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_names = 100'000;

struct Closer {
  void operator()(DIR* folder) const { ::closedir(folder); }
};
using OpenFolder = std::unique_ptr<DIR, Closer>;

/// Null if there is no such folder.
OpenFolder open_folder(int parent, const std::string& name, int more_flags) {
  const int descriptor = ::openat(parent, name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | more_flags);
  if (descriptor < 0) return nullptr;
  OpenFolder folder(::fdopendir(descriptor));
  if (!folder) ::close(descriptor);
  return folder;
}

OpenFolder open_root(const std::filesystem::path& folder) {
  OpenFolder root = open_folder(AT_FDCWD, folder.empty() ? "." : folder.string(), 0);
  if (!root) refuse_file(folder, std::string("cannot be read: ") + std::strerror(errno));
  return root;
}

bool is_a(int folder, const char* name, mode_t type) {
  struct stat status {};
  return ::fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && (status.st_mode & S_IFMT) == type;
}

/// Adds the files; returns the folders called Channel, ignoring case.
std::vector<std::string> list(DIR* folder, const std::string& prefix, std::vector<std::string>& names) {
  std::vector<std::string> channel_folders;
  while (const dirent* entry = ::readdir(folder)) {
    const std::string name = entry->d_name;
    if (is_a(::dirfd(folder), entry->d_name, S_IFREG)) names.push_back(prefix + name);
    if (lower_case(name) == "channel" && is_a(::dirfd(folder), entry->d_name, S_IFDIR))
      channel_folders.push_back(name);
    if (names.size() > max_names) break;
  }
  return channel_folders;
}

}  // namespace

std::vector<std::string> names_in_folder(const std::filesystem::path& folder) {
  const OpenFolder root = open_root(folder);
  std::vector<std::string> names;
  const std::vector<std::string> channel_folders = list(root.get(), "", names);
  if (channel_folders.size() > 1) refuse_file(folder, "has several folders called Channel");
  for (const std::string& name : channel_folders)
    if (const OpenFolder channels = open_folder(::dirfd(root.get()), name, O_NOFOLLOW))
      list(channels.get(), name + "/", names);
  if (names.size() > max_names) refuse_file(folder, "contains too many files");
  return names;
}

MmeMembers read_from_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                            std::size_t most, bool cut) {
  const OpenFolder root = open_root(folder);
  MmeMembers members;
  for (const std::string& name : names) {
    const auto slash = name.find('/');
    OpenFolder inner;
    if (slash != std::string::npos)
      inner = open_folder(::dirfd(root.get()), name.substr(0, slash), O_NOFOLLOW);
    const std::string last = slash == std::string::npos ? name : name.substr(slash + 1);
    if (last.find('/') != std::string::npos || (slash != std::string::npos && !inner))
      refuse_file(folder / name, "cannot be read");
    const int descriptor = ::openat(::dirfd(inner ? inner.get() : root.get()), last.c_str(),
                                    O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) refuse_file(folder / name, std::string("cannot be read: ") + std::strerror(errno));
    members[name] = read_descriptor(descriptor, (folder / name).string(), most, cut);
  }
  return members;
}

}  // namespace dashpad::input
