#pragma once
/// Compression tests from a table of numbers: CSV in, a material out.

#include <filesystem>
#include <optional>

#include "dashpad/input/material_deck.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// A column called strain, a pure number or in % ("strain", "strain [%]", "strain_percent"), and columns of
/// stress with their units ("stress_kPa", "stress [MPa]"). With several of them each header says its rate
/// behind an @: "stress_kPa @ 10 1/s". `rate`, 1/s, is that of a single column that does not say it.
/// Separators, quotes, comments and decimal commas as in pulse_csv.hpp; a stress may be left out where its
/// curve has ended. Gives all faults, or the first 200.
Reading<DeckMaterial> read_stress_table(const std::filesystem::path& file, std::optional<double> rate);

}  // namespace dashpad::input
