#pragma once
/// Files that were named on the command line may be streams: standard input, a pipe, a FIFO. They are read
/// once, to their end, before anything else is; readers of small files and of measurements then find the
/// bytes here. What a file names must be a regular file.

#include <cstddef>
#include <filesystem>
#include <string>

namespace dashpad::input {

inline constexpr std::size_t largest_stream = std::size_t{16} << 20;  // bytes

/// Reads `file` where it is - (standard input), a pipe or a FIFO, and keeps its bytes for this process; any
/// other file is left alone. Blocks until the other side closes: signals do what they do by default. Throws
/// InputError where it cannot be read, is larger than largest_stream, or is - for the second time. Not for
/// several threads.
void take_given_stream(const std::filesystem::path& file);

/// The bytes of a stream that was taken; nullptr for any other file.
const std::string* given_stream(const std::filesystem::path& file);

}  // namespace dashpad::input
