#pragma once
/// Tables of numbers as measuring programs write them: CSV in, a pulse out. docs/pulses.md has the rules.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/measurement/sensitivity.hpp"
#include "dashpad/input/pulse_file.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// What the file itself may not say. A column is named by its header, with or without its unit, or by its
/// number from 1.
struct PulseCsvOptions {
  std::string time = {};                       ///< empty: the column that the header calls so
  std::vector<std::string> acceleration = {};  ///< up to three; empty: as above
  std::string time_unit = {};                  ///< empty: from the header
  std::string acceleration_unit = {};          ///< empty: from the header. g is standard gravity
  bool resultant = false;                      ///< combine two or three columns: sqrt(x^2 + y^2 + z^2)
  bool bridge_gaps = false;                    ///< a straight line where samples are missing
  /// Of accelerations in volts: one for all, or one for each in their order. Empty: none is in volts.
  std::vector<Sensitivity> sensitivity = {};
  /// s, > 0, between two samples of a table without times, the first of which is at 0. A column of times is
  /// not read then.
  std::optional<double> interval = {};
};

/// Separated by commas, semicolons, tabs or blanks, or of one column; with header rows or without; decimal
/// commas where no comma separates. Units are never guessed. What is repaired is a remark; gaps, in the
/// rows and, unless they are to be bridged, in the times, text, numbers that are not finite, times that do
/// not increase and choices that are not clear are faults, of which the first 200 are given. At most 1 GiB
/// and 50 million samples.
Reading<PulseFile> read_pulse_csv(const std::filesystem::path& file, const PulseCsvOptions& options);

/// The columns with the units that the header gives; without header, numbers only.
Reading<std::vector<injury::MeasuredColumn>> pulse_csv_columns(const std::filesystem::path& file);

}  // namespace dashpad::input
