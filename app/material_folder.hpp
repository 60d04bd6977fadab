#pragma once
/// Where the command finds the material cards, the standards and the measured tests that came with it.

#include <filesystem>

namespace dashpad::app {

/// The first of:
///   1. $DASHPAD_MATERIALS, if set and not empty, whether or not it exists: a wrong path is to be noticed;
///   2. share/dashpad/materials of the installation that `executable` belongs to, if it exists;
///   3. materials/ of the source tree that the command was built from, if it exists.
/// If there is none, the second, so that a message can name the place where the cards were expected.
std::filesystem::path material_folder(const std::filesystem::path& executable);

/// The same for the presets of standards: $DASHPAD_STANDARDS, share/dashpad/standards, standards/.
std::filesystem::path standard_folder(const std::filesystem::path& executable);

/// The same for the measured tests of the validation: $DASHPAD_VALIDATION_DATA,
/// share/dashpad/data/validation, data/validation/.
std::filesystem::path validation_data_folder(const std::filesystem::path& executable);

/// The file of the running program; `argument_zero` where the system does not tell.
std::filesystem::path running_executable(const char* argument_zero);

}  // namespace dashpad::app
