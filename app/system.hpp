#pragma once
/// What differs between operating systems about a running program. system.cpp is that of Linux and other
/// systems of POSIX; windows/system.cpp is another.

#include <filesystem>
#include <span>
#include <string>

namespace dashpad::app {

/// The arguments of main() in UTF-8. Call once.
std::span<char*> arguments_in_utf8(int count, char** arguments);

/// A variable of the environment in UTF-8; empty if it is not set.
std::string environment(const char* variable);

/// The file of the running program, or the name by which it was called.
std::filesystem::path running_executable();

/// The standard stream that is redirected to a file, if any.
const char* stream_into(const std::filesystem::path& file);

/// Whether a path is a device or a pipe, which is written to directly.
bool is_device(const std::filesystem::path& path);

/// Why this program cannot write a file of this kind; empty if it can.
std::string missing_for(const std::filesystem::path& file);

}  // namespace dashpad::app
