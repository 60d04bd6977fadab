#pragma once
/// Lists of numbers and of quantities in TOML.

#include <optional>
#include <string>
#include <vector>

#include "input/table_reader.hpp"

namespace dashpad::input {

/// Plain numbers, each times `scale`, 2000 at most; those at fault are NaN. Nothing if there is no list.
std::optional<std::vector<double>> read_numbers(TableReader& table, const std::string& key, double scale = 1);

/// Quantities in SI, `most` of them at most; likewise.
std::optional<std::vector<double>> read_quantities(TableReader& table, const std::string& key,
                                                   const std::string& si_unit, std::size_t most);

}  // namespace dashpad::input
