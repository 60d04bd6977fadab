#pragma once
/// Fit files: TOML in, a checked fit out. docs/fits.md has the keys.

#include <filesystem>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/input/input_file.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::fit {

struct FitFile {
  Fit fit;
  std::vector<input::InputFile> files;  ///< that it was read from
};

/// `materials` is the folder in which material names are looked up; other files are looked for beside the fit
/// file. All faults of it and of the files that it names.
input::Reading<FitFile> read_fit(const std::filesystem::path& file, const std::filesystem::path& materials);

}  // namespace dashpad::fit
