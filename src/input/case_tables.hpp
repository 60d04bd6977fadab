#pragma once
/// The parts of a case file: the nose in [impactor], the material in [pad], the table [support], and values
/// in place of those of the file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/model/nose/nose.hpp"
#include "dashpad/model/nose/profile.hpp"
#include "dashpad/model/pad/law.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/model/support/support.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// A nose that is not named is a sphere. `folder`: from which the file of a profile is named; it is added to
/// `files`. Numbers at fault are NaN.
Nose read_nose(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files);

/// A column called depth, behind the tip, and one called radius or area, of the section there, each with its
/// unit in the header: "depth_mm,radius_mm", "depth [mm];area [cm2]". Other columns are not read. Separators,
/// quotes, comments and decimal commas as in measurement/tables.hpp. All faults, each with its line, or the
/// first 200.
Reading<Profile> read_profile_csv(const std::filesystem::path& file);

struct SupportEntry {
  Support support = {};  ///< rigid after a fault
  Backing backing = {};
  bool is_known = true;  ///< without a fault
};

SupportEntry read_support(TableReader& table);

struct PadMaterial {
  std::optional<Material> material;  ///< absent after a fault
  bool is_in_line = false;           ///< given in the file itself, so still to be checked
  std::optional<std::filesystem::path> card;
};

/// `material`, or a law with its tables.
PadMaterial read_pad_material(TableReader& pad, const Folders& folders);

/// What is left to be set when the case has been read: numbers that its file does not hold, but a card, or a
/// support that is known as a whole.
struct LaterSetting {
  std::string key, value;
};

/// Puts each "KEY=VALUE" into the tree, over what is there and over what it excludes (a weight under a mass,
/// a drop height under a speed, a law in the case under a card), and gives back what waits for the case. A
/// fault is one of "--set", under its key.
std::vector<LaterSetting> put_settings(const std::vector<std::string>& settings, TomlNode& root,
                                       FaultList& faults);

/// Into the case, with a unit. A material of which a number is set has it in its name.
void put_later(const std::vector<LaterSetting>& settings, ImpactCase& impact, FaultList& faults);

// Pad laws with the curves of foams, their fitted range and what is not known of them in TOML. Cards have
// them at their top, cases in [pad].

/// `law` and the table [parameters]; nothing if the law cannot be known. Parameters at fault are NaN.
std::optional<PadLaw> read_law(TableReader& table);

/// The optional table [fitted].
std::optional<FittedRange> read_fitted(TableReader& table);

/// The optional table [uncertainty]. Keys of the posterior that the law does not have are at fault.
Uncertainty read_uncertainty(TableReader& table, const PadLaw& law);

}  // namespace dashpad::input
