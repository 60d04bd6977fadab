#pragma once
/// Small text files that a user named, read with care: a wrong name must not hang or flood the program.

#include <filesystem>
#include <string>
#include <string_view>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// What some programs write before UTF-8 text; no part of it.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
std::string_view without_mark(std::string_view text);

/// The text of a regular file, or of a stream that was given, of at most 1 MiB. One fault for anything
/// else: missing, a folder, a pipe or a device, unreadable, larger, or not text.
Reading<std::string> read_text_file(const std::filesystem::path& file);

}  // namespace dashpad::input
