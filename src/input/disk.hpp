#pragma once
/// All that readers of cases, cards and standards ask of a disk, streams that the command line names, and
/// small text files, read with care: a wrong name must not hang or flood the program. Where there is no disk,
/// as in a browser, whoever hands out the texts has other functions in the place of those of disk.cpp.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

bool is_there(const std::filesystem::path& file);

/// The bytes of a regular file: at most one piece more than `most`, so that the caller sees that it is
/// larger. One fault for anything else: missing, a folder, a pipe or a device, unreadable.
Reading<std::string> content_of(const std::filesystem::path& file, std::size_t most);

/// The .toml files of a folder by name; `content`: what they hold, for the fault of one that is not readable.
Reading<std::vector<std::filesystem::path>> toml_files(const std::filesystem::path& folder,
                                                       std::string_view content);

/// Files that were named on the command line may be streams: standard input, a pipe, a FIFO. They are read
/// once, to their end, before anything else is; readers of small files and of measurements then find the
/// bytes here. What a file names must be a regular file.
inline constexpr std::size_t largest_stream = std::size_t{16} << 20;  // bytes

/// Reads `file` where it is - (standard input), a pipe or a FIFO, and keeps its bytes for this process; any
/// other file is left alone. Blocks until the other side closes: signals do what they do by default. Throws
/// InputError where it cannot be read, is larger than largest_stream, or is - for the second time. Not for
/// several threads.
void take_given_stream(const std::filesystem::path& file);

/// The bytes of a stream that was taken; nullptr for any other file.
const std::string* given_stream(const std::filesystem::path& file);

/// Bytes of a line above which no fault quotes it.
inline constexpr std::size_t longest_excerpt = 10'000;

/// What some programs write before UTF-8 text; no part of it.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
std::string_view without_mark(std::string_view text);

/// The text of a regular file, or of a stream that was given, of at most 1 MiB. One fault for anything
/// else: missing, a folder, a pipe or a device, unreadable, larger, or not text.
Reading<std::string> read_text_file(const std::filesystem::path& file);

}  // namespace dashpad::input
