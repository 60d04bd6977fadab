#pragma once
/// Access to the disk for cases, cards and standards; streams named on the command line; small text files. A
/// wrong name must not hang or flood the program. Without a disk, as in a browser, others replace disk.cpp.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

bool is_there(const std::filesystem::path& file);
bool is_link(const std::filesystem::path& file);
/// Whether two names are those of one file that is there.
bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other);

/// The bytes of a regular file, but not many more than `most`, so that the caller sees whether it is larger.
/// Anything else is a fault: missing, a folder, a pipe or a device, unreadable.
Reading<std::string> content_of(const std::filesystem::path& file, std::size_t most);

/// The .toml files of a folder by name. `content` describes them, for the fault of an unreadable folder.
Reading<std::vector<std::filesystem::path>> toml_files(const std::filesystem::path& folder,
                                                       std::string_view content);

/// Streams: files named on the command line may be standard input, a pipe or a FIFO. They are read once, to
/// their end, before anything else, and later found by the readers. Files named in files must be regular.
inline constexpr std::size_t largest_stream = std::size_t{16} << 20;  // bytes

/// If `file` is - (standard input), a pipe or a FIFO, reads it and keeps its bytes for this process. Blocks
/// until the other side closes; signals act as by default. Throws InputError if it is unreadable, larger than
/// largest_stream, or - for the second time. Not thread-safe.
void take_given_stream(const std::filesystem::path& file);

/// The bytes of a stream that was taken; nullptr for any other file.
const std::string* given_stream(const std::filesystem::path& file);

/// Faults quote no line of more bytes.
inline constexpr std::size_t longest_excerpt = 10'000;

/// The byte order mark that some programs write before UTF-8 text.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
std::string_view without_mark(std::string_view text);

/// The text of a regular file, or of a stream that was given, of at most 1 MiB. Anything else is a fault:
/// missing, a folder, a pipe or a device, unreadable, larger, or not text.
Reading<std::string> read_text_file(const std::filesystem::path& file);

}  // namespace dashpad::input
