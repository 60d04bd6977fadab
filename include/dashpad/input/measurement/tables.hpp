#pragma once
/// Tables of numbers as measuring programs write them, CSV: in them a pulse, a strain history or a
/// compression test; and a pulse that was read, where it came from. docs/pulses.md has the rules.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

struct Sensitivity {
  std::string text = {};              ///< as written: "10 mV/g"
  double volts_per_acceleration = 0;  ///< V per m/s2, more than 0
};

/// "10 mV/g", "1.02 mV/(m/s2)": a voltage, and behind the slash the unit of acceleration that it stands for;
/// g is standard gravity. Throws UnitError.
Sensitivity sensitivity_of(const std::string& text);

struct PulseFile {
  injury::MeasuredPulse measured;
  std::vector<InputFile> files;  ///< that it was read from: of a test, each of its parts
};

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

/// Units are never guessed. What is repaired is a remark; gaps, in the rows and, unless they are to be
/// bridged, in the times, text, numbers that are not finite, times that do not increase and choices that are
/// not clear are faults, of which the first 200 are given. At most 1 GiB and 50 million samples.
Reading<PulseFile> read_pulse_csv(const std::filesystem::path& file, const PulseCsvOptions& options);

/// The columns with the units that the header gives; without header, numbers only.
Reading<std::vector<injury::MeasuredColumn>> pulse_csv_columns(const std::filesystem::path& file);

struct StrainTable {
  std::vector<double> time = {};          ///< s, increasing
  std::vector<double> strain = {};        ///< the first is 0, all in [0, 1)
  std::vector<std::string> remarks = {};  ///< what was read otherwise than it stands, a sentence each
};

/// The header is needed: it names the time with its unit ("time [ms]", "t_s") and a column called strain, a
/// pure number or in % ("strain [%]"). Two rows at least, 10,000 at most; strain 0 first. Gives all faults,
/// each with its line, or the first 200.
Reading<StrainTable> read_strain_csv(const std::filesystem::path& file);

/// Which columns, by their header with or without its unit, and the units that the header does not say.
struct StressStrainColumns {
  std::string strain = "strain";
  std::string stress = "stress";
  std::string time = {};         ///< empty: the table has no times
  std::string strain_unit = {};  ///< "fraction" or "percent"; empty: from the header, which must say it
  std::string stress_unit = {};  ///< empty: from the header
  std::string time_unit = {};    ///< empty: from the header
};

struct StressStrainTable {
  std::vector<double> time = {};    ///< s, increasing; empty without a column of times
  std::vector<double> strain = {};  ///< engineering strain, below 1; may be below 0 by what noise makes
  std::vector<double> stress = {};  ///< Pa
};

/// The header is needed. Two rows at least, 10,000 at most. Gives all faults, each with its line, or the
/// first 200: a column that is missing, a unit that nobody stated, times that do not increase, a strain of 1
/// or more (per cent taken for a fraction), strains that are negative in compression.
Reading<StressStrainTable> read_stress_strain_csv(const std::filesystem::path& file,
                                                  const StressStrainColumns& columns);

}  // namespace dashpad::input
