#pragma once
/// The material in the table [pad] of a case or of a fit.

#include <filesystem>
#include <optional>

#include "dashpad/model/pad/material.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

struct PadMaterial {
  std::optional<Material> material;  ///< absent after a fault
  bool is_in_line = false;           ///< given in the file itself, so still to be checked
  std::optional<std::filesystem::path> card;
};

/// `material`, or a law with its tables. `folder` is that of the file, `materials` that of the cards.
PadMaterial read_pad_material(TableReader& pad, const std::filesystem::path& folder,
                              const std::filesystem::path& materials);

}  // namespace dashpad::input
