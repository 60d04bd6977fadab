#include "output.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

#include "quantities/text.hpp"

namespace dashpad::app {

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

namespace {

void write_to_output(std::string_view text) {
  const int error = write_all(STDOUT_FILENO, text);
  if (error != 0 && error != EPIPE)
    throw std::runtime_error("could not write to standard output: " + std::generic_category().message(error));
}

}  // namespace

void write_result(std::string_view text) {
  if (::isatty(STDOUT_FILENO) == 1) return write_output(text);
  write_to_output(text);
}

void write_output(std::string_view text) { write_to_output(without_controls(text)); }

void write_error(std::string_view text) { write_all(STDERR_FILENO, without_controls(text)); }

}  // namespace dashpad::app
