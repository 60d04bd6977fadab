#pragma once
/// Case files and material cards: TOML in, checked values out.

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/model/pad/material.hpp"

namespace dashpad::input {

struct CaseFile {
  ImpactCase impact;
  Options options;
  bool states_neighbours = false;  ///< not left to what is nominal for the material of the pad
  std::vector<InputFile> files;    ///< the case file, then those that it names: a profile, a card
};

/// Reads and checks a case. `materials` is the folder in which material names are looked up. `settings` are
/// "KEY=VALUE" each, with keys of the file ("pad.thickness=30 mm", "pad.layers[2].material=vn600") or of what
/// studies vary ("pad.curve.modulus=2 MPa"), and go before what the file has.
/// Faults are all that were found in the case and in the cards that it names; those of settings have "--set"
/// for a file.
Reading<CaseFile> read_case(const std::filesystem::path& file, const std::filesystem::path& materials,
                            const std::vector<std::string>& settings = {});

/// The same of a text that stands for a case file at `file`: what it names is looked for beside it.
Reading<CaseFile> read_case_text(std::string text, const std::filesystem::path& file,
                                 const std::filesystem::path& materials,
                                 const std::vector<std::string>& settings = {});

/// Reads and checks one material card.
Reading<Material> read_material(const std::filesystem::path& file);

/// The cards in a folder, sorted by name (the file name without .toml).
Reading<std::vector<std::filesystem::path>> list_materials(const std::filesystem::path& folder);

}  // namespace dashpad::input
