#pragma once
/// The profile of a nose from a table of numbers: CSV in, points out.

#include <filesystem>

#include "dashpad/input/reading.hpp"
#include "dashpad/model/nose/profile.hpp"

namespace dashpad::input {

/// A column called depth, behind the tip, and one called radius or area, of the section there, each with its
/// unit in the header: "depth_mm,radius_mm", "depth [mm];area [cm2]". Other columns are not read. Separators,
/// quotes, comments and decimal commas as in pulse_csv.hpp. All faults, each with its line, or the first
/// 200.
Reading<Profile> read_profile_csv(const std::filesystem::path& file);

}  // namespace dashpad::input
