#pragma once
/// One writer of a store at a time, however many read it.

#include <filesystem>

namespace dashpad::study {

/// A lock of the system on one byte of the file, far beyond its end and the bytes that SQLite locks. It goes
/// with the process, keeps no reader out, and leaves nothing behind. Two in one process exclude each other,
/// too.
class WriterLock {
 public:
  /// Makes the file where it is missing. Throws std::runtime_error: another run has the lock, or the file
  /// cannot be opened.
  explicit WriterLock(const std::filesystem::path& file);
  /// Closing a file drops the locks that SQLite has on it in this process: it must be closed before.
  ~WriterLock();
  WriterLock(WriterLock&& other) noexcept;
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  WriterLock& operator=(WriterLock&&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace dashpad::study
