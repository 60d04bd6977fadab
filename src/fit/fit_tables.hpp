#pragma once
/// Reading the tables and values of a fit file.

#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/input/reading.hpp"
#include "input/table_reader.hpp"

namespace dashpad::fit {

/// Read one of [[tests]] or [[impacts]], and add the files that it names to `files`.
MaterialMeasurement read_test(input::TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files);
ImpactMeasurement read_impact(input::TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files);

// Values. SI; NaN after a fault.

/// A value; pure numbers stand without quotes. In an acceleration, "3 g", g is standard gravity.
double value_of(const input::TomlNode& node, const std::string& key, const std::string& unit,
                input::FaultList& faults);
double value_in(input::TableReader& table, const std::string& key, const std::string& unit);
/// A quantity, or a share in % of `whole`.
double value_or_share(input::TableReader& table, const std::string& key, const std::string& unit,
                      double whole);

}  // namespace dashpad::fit
