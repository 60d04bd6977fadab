#pragma once
/// Study files: TOML, with units (docs/studies.md).

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// Reads a study, its base case, the cards and the CSV files that it names, relative to the study file.
/// All faults at once: of the study, of the case, of the factors.
input::Reading<Study> read_study(const std::filesystem::path& file, const std::filesystem::path& materials);

}  // namespace dashpad::study
