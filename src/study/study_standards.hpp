#pragma once
/// The standards that a study file names.

#include <filesystem>

#include "dashpad/study/study.hpp"
#include "input/table_reader.hpp"

namespace dashpad::study {

/// Reads `standard`, one or several: their impactor goes into the base case, what they limit into the
/// responses. `presets` is the folder of standards.
void read_standards(input::TableReader& top, const input::Folders& folders,
                    const std::filesystem::path& presets, Study& study);

}  // namespace dashpad::study
