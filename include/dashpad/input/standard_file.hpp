#pragma once
/// Presets of standards: TOML in, checked values out.

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

/// A name of a preset with variants, as people give it: "en-1078:kerbstone:small".
struct StandardChoice {
  std::string name;
  std::vector<std::string> variants;
};
StandardChoice standard_choice(const std::string& text);

/// The file of a preset: of that name in the folder, or a file anywhere if the name ends in .toml. A
/// fault names the presets there are.
Reading<std::filesystem::path> find_standard(const std::string& name, const std::filesystem::path& folder);

}  // namespace dashpad::input
