#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input/disk.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

 private:
  int number_;
};

/// Returns the size that the file system reports.
std::size_t require_regular(int descriptor, const std::string& name) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0)
    refuse_file(name, std::string("cannot be read: ") + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) refuse_file(name, "is a folder, not a file");
  if (!S_ISREG(status.st_mode)) refuse_file(name, "is not a regular file");
  return static_cast<std::size_t>(status.st_size);
}

}  // namespace

std::string read_bytes(int descriptor, const std::string& name, std::size_t most, std::size_t expected) {
  constexpr std::size_t step = 65536;
  std::string content(std::min(expected, most) + step, '\0');
  std::size_t size = 0;
  while (size < most) {
    if (content.size() == size) content.resize(2 * size);
    const ssize_t count = ::read(descriptor, content.data() + size, content.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_file(name, std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  content.resize(std::min(size, most));
  return content;
}

std::string read_descriptor(int descriptor, const std::string& name, std::size_t most, bool cut) {
  const Descriptor closing(descriptor);
  const std::size_t told = require_regular(descriptor, name);
  const bool is_refused = told > most && !cut;
  std::string content = is_refused ? "" : read_bytes(descriptor, name, most + 1, told);
  if (is_refused || (content.size() > most && !cut))
    refuse_file(name, fmt::format("is larger than {} MiB", most >> 20));
  content.resize(std::min(content.size(), most));
  return content;
}

std::string read_measurement(const std::filesystem::path& file, std::size_t most) {
  if (const std::string* given = given_stream(file)) return *given;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0 && errno == ENOENT) refuse_file(file.string(), "no such file");
  if (descriptor < 0 && errno == ENXIO) refuse_file(file.string(), "is not a regular file");
  if (descriptor < 0) refuse_file(file.string(), std::string("cannot be read: ") + std::strerror(errno));
  return read_descriptor(descriptor, file.string(), most);
}

}  // namespace dashpad::input
