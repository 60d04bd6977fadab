#pragma once
/// Reading the tables and values of a fit file.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/input/reading.hpp"
#include "input/table_reader.hpp"

namespace dashpad::fit {

/// An impact of which only the material matters.
ImpactCase made_up_case();

/// Reads one of [[tests]], and adds the files that it names to `files`.
MaterialMeasurement read_test(input::TableReader& table, const input::Folders& folders,
                              std::vector<input::InputFile>& files);
/// The points of a table as those of a test, at a rate in 1/s or at the times of the table.
void take_points(input::StressStrainTable read, std::optional<double> rate, MaterialMeasurement& test);
/// Reads the pulse of an impact, {file = ..., deviation = ...}; none after a fault.
std::optional<MeasuredDeceleration> read_pulse(input::TableReader& table, const input::Folders& folders,
                                               std::vector<input::InputFile>& files);
/// An entry of [[impacts]] is one impact, or with rows = "drops.csv" one for each row of that table: the case
/// with the numbers of the row, and the measured figures of the row with the deviation of the entry.
/// A number of the case that an unknown of the fit would overrule is a fault.
void read_impacts(input::TableReader& table, const input::Folders& folders,
                  std::vector<input::InputFile>& files, Fit& fit);

/// The impacts of such a table, made from `stem`, which has the case. Empty after a fault.
std::vector<ImpactMeasurement> read_drops(input::TableReader& table, const input::Folders& folders,
                                          const ImpactMeasurement& stem, const Fit& fit,
                                          std::vector<input::InputFile>& files);

/// The entries of `set` as settings, "impactor.mass=6 kg"; tables are opened.
std::vector<std::string> settings_in(const input::TomlNode& set, const std::string& prefix = "");

/// The keys of a fit in place of the options in a rule: "bridge_gaps" for "--bridge-gaps".
std::string with_keys(std::string rule);

/// What was read; faults are added in words of a fit file.
template <class T>
std::optional<T> taken_with_keys(input::Reading<T> reading, input::FaultList& faults) {
  if (reading) return *std::move(reading);
  for (input::Fault fault : reading.faults()) {
    fault.rule = with_keys(std::move(fault.rule));
    faults.add({std::move(fault)});
  }
  return std::nullopt;
}

// Values. SI; NaN after a fault.

/// A value; pure numbers stand without quotes. In an acceleration, "3 g", g is standard gravity.
double value_of(const input::TomlNode& node, const std::string& key, const std::string& unit,
                input::FaultList& faults);
double value_in(input::TableReader& table, const std::string& key, const std::string& unit);
/// A quantity, or a share in % of `whole`.
double value_or_share(input::TableReader& table, const std::string& key, const std::string& unit,
                      double whole);

}  // namespace dashpad::fit
