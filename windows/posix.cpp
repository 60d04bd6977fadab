// The functions of include/: the system calls of POSIX that the sources name, by those of Windows.

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>

#include <fcntl.h>
#include <io.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace {

int errno_of(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND: return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: return EEXIST;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_WRITE_PROTECT: return EACCES;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL: return ENOSPC;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    default: return EIO;
  }
}

int failed(DWORD error) {
  errno = errno_of(error);
  return -1;
}

/// Tries again for a while, since virus scanners hold new files for a moment.
int move(const wchar_t* from, const wchar_t* to, DWORD flags) {
  constexpr int tries = 5;
  constexpr DWORD pause = 50;  // ms
  for (int tried = 1;; ++tried) {
    if (MoveFileExW(from, to, flags | MOVEFILE_WRITE_THROUGH) != 0) return 0;
    const DWORD error = GetLastError();
    if (tried == tries || errno_of(error) != EACCES) return failed(error);
    Sleep(pause);
  }
}

constexpr std::size_t max_at_once = std::size_t{1} << 30;  // bytes

bool are_interrupts_held = false;

}  // namespace

int open(const wchar_t* file, int flags, int mode) {
  const DWORD attributes = GetFileAttributesW(file);
  if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
    errno = EISDIR;
    return -1;
  }
  return _wopen(file, flags | _O_BINARY, mode & (_S_IREAD | _S_IWRITE));
}

int rename(const wchar_t* from, const wchar_t* to) { return move(from, to, MOVEFILE_REPLACE_EXISTING); }

int renameat2(int /*folder*/, const wchar_t* from, int /*other_folder*/, const wchar_t* to,
              unsigned /*flags*/) {
  return move(from, to, 0);
}

int access(const wchar_t* folder, int /*mode*/) {
  const std::wstring tried =
      std::wstring(folder) + L"\\.dashpad-" + std::to_wstring(GetCurrentProcessId()) + L".try";
  const HANDLE file = CreateFileW(tried.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                                  FILE_ATTRIBUTE_NORMAL | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (file == INVALID_HANDLE_VALUE) return failed(GetLastError());
  CloseHandle(file);
  return 0;
}

int link(const wchar_t* from, const wchar_t* to) {
  return CreateHardLinkW(to, from, nullptr) != 0 ? 0 : failed(GetLastError());
}

int unlink(const wchar_t* file) { return _wunlink(file); }

int fsync(int descriptor) { return _commit(descriptor); }

ssize_t read(int descriptor, void* bytes, std::size_t size) {
  return _read(descriptor, bytes, static_cast<unsigned>(std::min(size, max_at_once)));
}

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  return _write(descriptor, bytes, static_cast<unsigned>(std::min(size, max_at_once)));
}

int stat(const wchar_t* file, struct stat* status) { return _wstat64(file, status); }

int fchmod(int /*descriptor*/, unsigned /*mode*/) { return 0; }

int sigaction(int signal, const struct sigaction* action, struct sigaction* before) {
  const auto found = ::signal(signal, action != nullptr ? action->sa_handler : SIG_GET);
  if (found == SIG_ERR) return -1;
  if (before != nullptr) *before = {found, 0};
  return 0;
}

int sigemptyset(sigset_t* signals) {
  *signals = false;
  return 0;
}

int sigaddset(sigset_t* signals, int /*signal*/) {
  *signals = true;
  return 0;
}

int pthread_sigmask(int /*how*/, const sigset_t* signals, sigset_t* before) {
  if (before != nullptr) *before = are_interrupts_held;
  const auto hold = [](DWORD event) -> BOOL { return event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT; };
  if (*signals != are_interrupts_held) SetConsoleCtrlHandler(hold, *signals ? TRUE : FALSE);
  are_interrupts_held = *signals;
  return 0;
}
