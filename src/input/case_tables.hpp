#pragma once
/// The parts of a case file: nose, material and support, and values that override those of the file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/model/nose/nose.hpp"
#include "dashpad/model/nose/profile.hpp"
#include "dashpad/model/pad/law.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/model/support/support.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// Reads the nose, by default a sphere. The file of a profile is found in `folder` and added to `files`.
/// Numbers at fault are NaN.
Nose read_nose(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files);

/// Reads a profile: a column called depth, behind the tip, and one called radius or area, of the section
/// there, with units in the header: "depth_mm,radius_mm", "depth [mm];area [cm2]". Other columns are ignored.
/// Reports all faults with their lines, or the first 200.
Reading<Profile> read_profile_csv(const std::filesystem::path& file);

struct SupportEntry {
  Support support = {};  ///< rigid after a fault
  Backing backing = {};
  bool is_known = true;
};

SupportEntry read_support(TableReader& table);

struct PadMaterial {
  std::optional<Material> material;  ///< absent after a fault
  bool is_in_line = false;           ///< given in the file itself, so not yet checked
  std::optional<std::filesystem::path> card;
};

/// Reads and checks a case that is already a tree; files that it names are relative to the folder of `file`.
Reading<CaseFile> read_case_tree(TomlFile& toml, const std::filesystem::path& file,
                                 const std::filesystem::path& materials);

/// Reads `material`, or a law with its tables.
PadMaterial read_pad_material(TableReader& pad, const Folders& folders);

/// A setting that must wait until the case has been read, because its number is held by a card or a support.
struct LaterSetting {
  std::string key, value;
};

/// Puts each "KEY=VALUE" into the tree, replacing what is there and what it excludes (a weight for a mass, a
/// drop height for a speed, a law in the case for a card). Returns the settings that must wait. Faults belong
/// to "--set", under the key.
std::vector<LaterSetting> put_settings(const std::vector<std::string>& settings, TomlNode& root,
                                       FaultList& faults);

/// Applies the settings to the case. The name of a material then includes its changed numbers.
void put_later(const std::vector<LaterSetting>& settings, ImpactCase& impact, FaultList& faults);

// Pad laws, their fitted range and their uncertainty, which are at the top of cards and in [pad] of cases.

/// Reads `law` and [parameters]; absent if the law is unknown. Parameters at fault are NaN.
std::optional<PadLaw> read_law(TableReader& table);

/// The optional table [fitted].
std::optional<FittedRange> read_fitted(TableReader& table);

/// Reads the optional table [uncertainty]. Keys of the posterior must be numbers of the law.
Uncertainty read_uncertainty(TableReader& table, const PadLaw& law);

}  // namespace dashpad::input
