#pragma once
/// All that readers of cases, cards and standards ask of a disk. Where there is none, as in a browser,
/// whoever hands out the texts has other functions in the place of these.

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

/// The .toml files of a folder by name; `of`: what they hold, for the fault of one that is not readable.
Reading<std::vector<std::filesystem::path>> toml_files(const std::filesystem::path& folder,
                                                       std::string_view of);

}  // namespace dashpad::input
