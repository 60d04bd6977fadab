#pragma once
/// The tables of a fit file, each read by a function of its own.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/input/reading.hpp"
#include "input/table_reader.hpp"

namespace dashpad::fit {

/// The lines of the keys that broken rules may name.
using Lines = std::map<std::string, int>;

/// [unknowns]. Without a sound base, names of the law are taken on trust.
void read_unknowns(input::TableReader& top, bool has_base, Fit& fit, Lines& lines);
/// The pulse of an impact: {file = ..., deviation = ...}. Nothing after a fault.
std::optional<MeasuredDeceleration> read_pulse(input::TableReader& table, const input::Folders& folders,
                                               std::vector<input::InputFile>& files);
/// Read one of [[tests]] or [[impacts]] and add the files that it names to `files`.
MaterialMeasurement read_test(input::TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files);
ImpactMeasurement read_impact(input::TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files);

// Values. SI; NaN after a fault.

/// A value: pure numbers stand without quotes. In an acceleration, "3 g", g is standard gravity; elsewhere in
/// files it is the gram.
double value_of(const input::TomlNode& node, const std::string& key, const std::string& unit,
                input::FaultList& faults);
double value_in(input::TableReader& table, const std::string& key, const std::string& unit);
/// A quantity, or a share in % of `whole`.
double value_or_share(input::TableReader& table, const std::string& key, const std::string& unit,
                      double whole);

}  // namespace dashpad::fit
