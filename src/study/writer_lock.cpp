#include "study/writer_lock.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace dashpad::study {

namespace {

constexpr off_t place_of_lock = off_t{1} << 62;

[[noreturn]] void refuse(const std::filesystem::path& file, int error) {
  std::string why = std::string{"it cannot be opened ("} + std::strerror(error) + ")";
  if (error == EACCES || error == EPERM || error == EROFS)
    why = "it cannot be written to: its file or its folder is read-only";
  if (error == EAGAIN) why = "another run is writing it: wait for its end, or stop it, and try again";
  throw std::runtime_error(file.string() + ": " + why);
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) refuse(file, errno);
  // Of the open file, not of the process (F_SETLK): SQLite opens and closes the same file on its own.
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = place_of_lock;
  lock.l_len = 1;
  if (::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return;
  const int error = errno == EACCES ? EAGAIN : errno;
  ::close(descriptor_);
  refuse(file, error);
}

WriterLock::~WriterLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

WriterLock::WriterLock(WriterLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace dashpad::study
