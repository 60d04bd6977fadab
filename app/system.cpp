#include "system.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "output.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

std::span<char*> arguments_in_utf8(int count, char** arguments) {
  return {arguments, static_cast<std::size_t>(count)};
}

std::string environment(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

fs::path running_executable() {
  std::error_code error;
  fs::path executable = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path{program_invocation_name} : executable;
}

const char* stream_into(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return nullptr;
  if (fs::equivalent(file, "/dev/stdout", error)) return "standard output";
  if (fs::equivalent(file, "/dev/stderr", error)) return "standard error";
  return nullptr;
}

bool is_device(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string missing_for(const fs::path& /*file*/) { return ""; }

void prepare_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Opened read-only, so that writing to a closed standard output still fails. Takes the lowest free number.
  while (true) {
    const int descriptor = ::open("/dev/null", O_RDONLY);
    if (descriptor <= STDERR_FILENO && descriptor >= 0) continue;
    if (descriptor > STDERR_FILENO) ::close(descriptor);
    return;
  }
}

}  // namespace dashpad::app
