#pragma once
/// The nose in the table [impactor] of a case.

#include <filesystem>
#include <vector>

#include "dashpad/input/input_file.hpp"
#include "dashpad/model/nose/nose.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// A nose that is not named is a sphere. `folder`: from which the file of a profile is named; it is added to
/// `files`. Numbers at fault are NaN.
Nose read_nose(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files);

}  // namespace dashpad::input
