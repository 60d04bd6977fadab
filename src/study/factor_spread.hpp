#pragma once
/// Reading the spread of a factor from a study file.

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/study/study.hpp"
#include "input/table_reader.hpp"

namespace dashpad::study {

/// The spread of a factor: values, a range or a distribution. `unit` is SI, "1" for a pure number.
Spread read_spread(input::TableReader& table, const std::string& unit, const input::Folders& folders);

/// Sorted values of a column in SI.
input::Reading<std::vector<double>> read_empirical(const std::filesystem::path& file,
                                                   const std::string& column, const std::string& unit);

}  // namespace dashpad::study
