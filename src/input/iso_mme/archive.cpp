// ISO-MME tests in a zip or tar, unpacked into memory and never onto the disk.

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input/iso_mme/test_files.hpp"
#include "input/measurement/measurement_text.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_entries = 10'000;
constexpr std::size_t longest_name = 1000;
/// Largest total size of a tar, all of which must be unpacked to skip files, unlike a zip.
constexpr std::int64_t largest_tar = std::int64_t{1} << 34;

class Archive {
 public:
  explicit Archive(const std::filesystem::path& file) : name_(file.string()) {
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor_ < 0) refuse_file(name_, std::string("cannot be read: ") + std::strerror(errno));
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) fail("is not a regular file");
    archive_.reset(::archive_read_new());
    if (!archive_) fail("cannot be read: not enough memory");
    ::archive_read_support_format_zip_seekable(archive_.get());
    ::archive_read_support_format_tar(archive_.get());
    ::archive_read_support_filter_gzip(archive_.get());
    if (::archive_read_open_fd(archive_.get(), descriptor_, 65536) != ARCHIVE_OK) fail(no_archive);
  }
  ~Archive() {
    archive_.reset();
    ::close(descriptor_);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// Goes to the next regular file; false at the end.
  bool next(std::string& name) {
    while (true) {
      const int result = ::archive_read_next_header(archive_.get(), &entry_);
      if (result == ARCHIVE_EOF) return false;
      if (result < ARCHIVE_WARN) refuse_file(name_, no_archive);
      if (++entries_ > max_entries) refuse_file(name_, fmt::format("has more than {} files", max_entries));
      if ((::archive_format(archive_.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_TAR) count_size();
      name = safe_name();
      if (::archive_entry_filetype(entry_) == AE_IFREG && ::archive_entry_hardlink(entry_) == nullptr)
        return true;
    }
  }

  /// Reads the current entry. `room` is how much may still be unpacked.
  std::string read(const std::string& name, std::size_t most, bool cut, std::size_t& room) {
    std::string content;
    std::array<char, 65536> block{};
    while (content.size() < most || !cut) {
      const la_ssize_t count = ::archive_read_data(archive_.get(), block.data(), block.size());
      if (count == 0) break;
      if (count < 0) refuse_file(name_, one_line(name) + ": " + no_archive);
      const auto size = static_cast<std::size_t>(count);
      if (size > room)
        refuse_file(name_, fmt::format("unpacks to more than {} MiB", largest_measurement >> 20));
      room -= size;
      if (content.size() + size > most && !cut)
        refuse_file(name_, fmt::format("{}: is larger than {} MiB", one_line(name), most >> 20));
      content.append(block.data(), std::min(size, most - content.size()));
    }
    return content;
  }

 private:
  struct Deleter {
    void operator()(archive* opened) const { ::archive_read_free(opened); }
  };

  [[noreturn]] void fail(const std::string& rule) {
    archive_.reset();
    ::close(descriptor_);
    refuse_file(name_, rule);
  }

  static constexpr const char* no_archive =
      "cannot be unpacked: it is not a zip, tar or gzipped tar, or it is damaged, truncated or encrypted";

  void count_size() {
    const std::int64_t size = ::archive_entry_size_is_set(entry_) != 0 ? ::archive_entry_size(entry_) : 0;
    if (size < 0 || size > largest_tar - claimed_) refuse_file(name_, "is too large for a tar; use a zip");
    claimed_ += size;
  }

  /// The name with / between folders and without "./". A name that leads out makes all of it untrustworthy.
  std::string safe_name() {
    const char* text = ::archive_entry_pathname_utf8(entry_);
    if (text == nullptr) text = ::archive_entry_pathname(entry_);
    std::string name = text == nullptr ? "" : text;
    if (name.size() > longest_name) refuse_file(name_, "contains a name that is too long");
    std::ranges::replace(name, '\\', '/');
    const bool has_drive = name.size() > 1 && name[1] == ':';
    const std::string framed = "/" + name + "/";
    if (name.starts_with('/') || has_drive || framed.find("/../") != std::string::npos)
      refuse_file(name_,
                  fmt::format("contains the name \"{}\", which points outside the archive", one_line(name)));
    while (name.starts_with("./")) name.erase(0, 2);
    return name;
  }

  std::string name_;
  int descriptor_ = -1;
  std::unique_ptr<archive, Deleter> archive_;
  archive_entry* entry_ = nullptr;
  std::size_t entries_ = 0;
  std::int64_t claimed_ = 0;
};

}  // namespace

std::vector<std::string> names_in_archive(const std::filesystem::path& archive) {
  Archive opened(archive);
  std::set<std::string> seen;
  std::string name;
  while (opened.next(name))
    if (!seen.insert(name).second)
      refuse_file(archive.string(), fmt::format("contains \"{}\" twice", one_line(name)));
  return {seen.begin(), seen.end()};
}

MmeMembers read_from_archive(const std::filesystem::path& archive, const std::vector<std::string>& names,
                             std::size_t most, bool cut) {
  Archive opened(archive);
  const std::set<std::string> wanted(names.begin(), names.end());
  MmeMembers members;
  std::size_t room = largest_measurement;
  std::string name;
  while (members.size() < wanted.size() && opened.next(name))
    if (wanted.contains(name)) members[name] = opened.read(name, most, cut, room);
  return members;
}

}  // namespace dashpad::input
