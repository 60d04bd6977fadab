#pragma once
/// Standard output and standard error, with every failure noticed.

#include <string_view>

namespace dashpad::app {

/// Call first. A reader that goes away or a limit on file sizes becomes an error code instead of a signal,
/// and no file that is opened later can take the place of a standard stream that is closed.
void prepare_streams();

/// Writes all of `text` to a file descriptor. Returns 0, or the error number of the system.
int write_all(int descriptor, std::string_view text);

/// What is for people, to standard output, without control characters. A reader that has gone away has seen
/// enough: no error. Throws std::runtime_error where the text cannot be written, on a full disk for example.
void write_output(std::string_view text);

/// What is for programs, to standard output, as it is; a terminal gets it as write_output() would give it.
void write_result(std::string_view text);

/// What is for people, to standard error, where possible.
void write_error(std::string_view text);

}  // namespace dashpad::app
