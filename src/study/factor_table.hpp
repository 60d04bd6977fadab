#pragma once
/// The table [factors] of a study file.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dashpad/study/study.hpp"
#include "input/table_reader.hpp"

namespace dashpad::study {

inline constexpr double default_tolerance = 1e-3;

/// Where each factor stands in the file.
struct FactorLines {
  std::map<std::string, int> lines;
  std::vector<std::string> at_fault;  ///< "factors.KEY", and others that need no second fault
};

/// Adds the factors, and the materials that "pad.material" names, to a study. A factor at fault is added as
/// far as it can be read. Without a base case a parameter or a support is taken on trust.
FactorLines read_factors(input::TableReader& top, bool has_base, const input::Folders& folders, Study& study);

/// Adds broken rules of the study with their lines, but not those of factors at fault.
void add_violations(const std::vector<Violation>& broken, const input::TomlNode& root,
                    const FactorLines& lines, input::FaultList& faults);

/// The spread of a factor: values, a range or a distribution. `unit` is SI, "1" for a pure number.
Spread read_spread(input::TableReader& table, const std::string& unit, const input::Folders& folders);

/// Sorted values of a column in SI.
input::Reading<std::vector<double>> read_empirical(const std::filesystem::path& file,
                                                   const std::string& column, const std::string& unit);

}  // namespace dashpad::study
