#pragma once
/// Reads and checks case files and material cards (TOML).

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/model/pad/material.hpp"

namespace dashpad::input {

struct CaseFile {
  ImpactCase impact;
  Options options;
  bool states_neighbours = false;  ///< else nominal for the material of the pad
  std::vector<InputFile> files;    ///< the case file and the files that it names
};

/// Reads and checks a case. Names of materials refer to cards in the folder `materials`. `settings` are
/// "KEY=VALUE" each and override the file; keys are those of the file ("pad.thickness=30 mm",
/// "pad.layers[2].material=vn600") or of studies ("pad.curve.modulus=2 MPa"). Reports all faults of the case
/// and of its cards; those of settings have "--set" for a file.
///
/// Example:
/// \code
/// const auto read = dashpad::input::read_case("drop.toml", "materials", {"pad.thickness=30 mm"});
/// for (const dashpad::input::Fault& fault : read.faults()) std::puts(to_string(fault).c_str());
/// if (read) std::printf("%s: %.2f m/s\n", read->impact.title.c_str(), read->impact.impactor.speed);
/// \endcode
Reading<CaseFile> read_case(const std::filesystem::path& file, const std::filesystem::path& materials,
                            const std::vector<std::string>& settings = {});

/// Reads a text as the case file `file`, in whose folder other files are found.
Reading<CaseFile> read_case_text(std::string text, const std::filesystem::path& file,
                                 const std::filesystem::path& materials,
                                 const std::vector<std::string>& settings = {});

/// A case of a batch, one JSON object in a line.
struct JsonCase {
  std::string id;          ///< the value of "id" as JSON; empty if absent
  Reading<CaseFile> read;  ///< faults are those of `file`, with the line of the object
};

/// Reads a line of a batch: {"id": 7, "case": "drop.toml", "set": {"pad.thickness": "30 mm"}}, with keys as
/// for --set, or the tables of a case file as JSON: {"impactor": {"mass": "4.5 kg", ...}, "pad": {...},
/// "support": {...}}. Values are written as in a case file: texts with units, plain numbers. Files are
/// relative to `folder`.
JsonCase read_case_json(std::string_view text, int line, const std::string& file,
                        const std::filesystem::path& folder, const std::filesystem::path& materials);

/// Reads and checks one material card.
Reading<Material> read_material(const std::filesystem::path& file);

/// The cards in a folder, sorted by name (the file name without .toml).
Reading<std::vector<std::filesystem::path>> list_materials(const std::filesystem::path& folder);

}  // namespace dashpad::input
