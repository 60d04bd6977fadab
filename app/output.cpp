#include "output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail(const std::string& name, int error) {
  throw std::runtime_error("could not write " + name + ": " + reason(error));
}

bool is_taken(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path{"."};
}

/// The path without links, "." and "..", even if the target of a link does not exist.
fs::path place_of(const fs::path& file) {
  constexpr int max_links = 40;  // as the system follows
  std::error_code error;
  fs::path path = fs::absolute(file, error);
  for (int links = 0; links < max_links && fs::is_symlink(path, error); ++links)
    path = path.parent_path() / fs::read_symlink(path, error);
  const fs::path place = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : place;
}

/// Why a target cannot be written; empty if it can.
std::string complaint(const Target& target, bool force) {
  const fs::path path{target.file};
  std::error_code error;
  if (fs::is_directory(path, error) || !path.has_filename()) return "is a folder; give the name of a file";
  if (std::string missing = missing_for(path); !missing.empty()) return missing;
  if (is_device(path)) return "";
  if (is_taken(path) && !force) return "already exists; choose another name, or use --force to overwrite it";
  const fs::path folder = folder_of(fs::is_symlink(path, error) ? place_of(path) : path);
  if (!fs::is_directory(folder, error)) return "there is no folder " + folder.string();
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return "cannot create a file in " + folder.string() + ": " + reason(errno);
  return "";
}

/// Opens a file with a unique name in `folder`, with the mode of new files.
int open_draft(const fs::path& folder, fs::path& draft) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    draft = folder / (".dashpad-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part");
    const int file = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

/// Renames `draft` to `target` if that name is free. Returns 0 or the error number.
int rename_to_free_name(const fs::path& draft, const fs::path& target) {
#ifdef RENAME_NOREPLACE
  if (::renameat2(AT_FDCWD, draft.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
#endif
  if (::link(draft.c_str(), target.c_str()) != 0) return errno;
  ::unlink(draft.c_str());
  return 0;
}

/// Makes the new name survive a power failure, if the system supports it.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void write_device(const std::string& name, const fs::path& device, std::string_view text) {
  const int descriptor = ::open(device.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(name, errno);
  const int error = write_all(descriptor, text);
  ::close(descriptor);
  if (error != 0 && error != EPIPE) fail(name, error);
}

/// Whether both names lead to one file, by spelling, symbolic or hard links. Neither need exist.
bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) || place_of(a) == place_of(b);
}

}  // namespace

void judge_targets(const std::vector<Target>& targets, const std::vector<input::InputFile>& inputs,
                   bool force, std::vector<std::string>& errors) {
  for (auto target = targets.begin(); target != targets.end(); ++target) {
    const auto say = [&](const std::string& what) {
      errors.push_back(target->option + " " + target->file + ": " + what);
    };
    for (auto earlier = targets.begin(); earlier != target; ++earlier) {
      if (target->is_standard_output() && earlier->is_standard_output())
        say("only one result can go to standard output");
      else if (target->is_standard_output() || earlier->is_standard_output())
        continue;
      else if (is_same_file(target->file, earlier->file))
        say("is also given for " + earlier->option + "; choose another name");
    }
    if (target->is_standard_output()) continue;
    const auto input = std::ranges::find_if(
        inputs, [&](const input::InputFile& read) { return is_same_file(target->file, read.file); });
    if (input != inputs.end())
      say("is " + input->kind + "; choose another name");
    else if (const char* stream = stream_into(target->file))
      say(std::string{"is where "} + stream + " is redirected; choose another name");
    else if (const std::string what = complaint(*target, force); !what.empty())
      say(what);
  }
}

PendingFile::PendingFile(const Target& target, bool force)
    : name_(target.file), target_(target.file), force_(force) {
  if (is_device(target_)) return;
  if (force) target_ = place_of(target_);
  descriptor_ = open_draft(folder_of(target_), draft_);
  if (descriptor_ >= 0) return;
  draft_.clear();
  fail(name_, errno);
}

PendingFile::PendingFile(const Target& target, std::string_view text, bool force)
    : PendingFile(target, force) {
  if (draft_.empty())
    write_device_ = [name = name_, device = target_, held = std::string{text}] {
      write_device(name, device, held);
    };
  else
    settle(write_all(descriptor_, text));
}

PendingFile::PendingFile(const Target& target, const WriteFile& write, bool force)
    : PendingFile(target, force) {
  if (draft_.empty()) {
    write_device_ = [write, device = target_] { write(device); };
    return;
  }
  write(draft_);
  settle(0);
}

/// Gives the draft the mode of the file that it replaces, syncs and closes it. `problem`: errno or 0.
void PendingFile::settle(int problem) {
  struct stat old {};
  if (force_ && ::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor_, old.st_mode & 07777);
  if (problem == 0 && ::fsync(descriptor_) != 0) problem = errno;
  if (::close(std::exchange(descriptor_, -1)) != 0 && problem == 0) problem = errno;
  if (problem != 0) fail(name_, problem);
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!draft_.empty()) ::unlink(draft_.c_str());
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      draft_(std::exchange(other.draft_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      write_device_(std::move(other.write_device_)),
      force_(other.force_) {}

void PendingFile::publish() {
  if (draft_.empty()) {
    write_device_();
    return;
  }
  const int error = force_ ? (::rename(draft_.c_str(), target_.c_str()) == 0 ? 0 : errno)
                           : rename_to_free_name(draft_, target_);
  if (error != 0) fail(name_, error);
  draft_.clear();
  sync_folder(folder_of(target_));
}

std::string publish(const std::vector<Target>& targets, bool force, const TextOf& text_of) {
  std::vector<PendingFile> files;
  std::string output;
  for (const Target& target : targets) {
    std::string text = text_of(target);
    if (target.is_standard_output())
      output = std::move(text);
    else
      files.emplace_back(target, text, force);
  }
  for (PendingFile& file : files) file.publish();
  return output;
}

void publish(const std::vector<Target>& targets, bool force, const TextOf& text_of,
             std::string_view summary) {
  const std::string output = publish(targets, force, text_of);
  if (output.empty()) {
    write_output(summary);
  } else {
    write_error(summary);
    write_result(output);
  }
}

}  // namespace dashpad::app
