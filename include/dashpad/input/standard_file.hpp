#pragma once
/// Reads and checks presets of standards (TOML).

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/injury/standard.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// Reads and checks one preset.
Reading<injury::Standard> read_standard(const std::filesystem::path& file);

/// The presets in a folder, sorted by name (the file name without .toml).
Reading<std::vector<std::filesystem::path>> list_standards(const std::filesystem::path& folder);

/// A preset with variants, as in "en-1078:kerbstone:small".
struct StandardChoice {
  std::string name;
  std::vector<std::string> variants;
};
StandardChoice standard_choice(const std::string& text);

/// The file of a preset: the one of that name in the folder, or any file whose name ends in .toml. A fault
/// lists the available presets.
Reading<std::filesystem::path> find_standard(const std::string& name, const std::filesystem::path& folder);

}  // namespace dashpad::input
