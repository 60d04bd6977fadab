#pragma once
/// Tables of numbers (CSV) from measuring programs: pulses, strains, compression (docs/pulses.md).

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

struct Sensitivity {
  std::string text = {};              ///< as written: "10 mV/g"
  double volts_per_acceleration = 0;  ///< V per m/s2, more than 0
};

/// A voltage per acceleration: "10 mV/g", "1.02 mV/(m/s2)", where g is standard gravity. Throws UnitError.
Sensitivity sensitivity_of(const std::string& text);

/// The times, s, between which a sensor's offset is the mean: "0 ms,5 ms". Absent for "auto". Throws
/// UnitError.
std::optional<std::pair<double, double>> interval_of_zero(const std::string& text);

/// The part of a record that is used, s, on the printed scale of times; all of it without.
struct CutTimes {
  std::optional<double> from = {}, to = {};
};

struct PulseFile {
  injury::MeasuredPulse measured;
  std::vector<InputFile> files;  ///< source files; for a test, all its parts
};

/// Settings for what the file may not say itself. Columns of a table are named by their headers, with or
/// without unit, or by numbers from 1; a test in ISO-MME has channels.
struct PulseOptions {
  std::string test = {};  ///< its name in ISO-MME, where folder or archive have several
  /// In ISO-MME: its number, or its code in which ? stands for any character; empty for the only
  /// acceleration, or with `resultant` for the directions X, Y, Z of the only place.
  std::string channel = {};
  std::string time = {};                       ///< empty for the column that looks like one
  std::vector<std::string> acceleration = {};  ///< up to three; empty likewise
  std::string time_unit = {};                  ///< empty for that of the header
  std::string acceleration_unit = {};          ///< empty for that of the header; g is standard gravity
  bool resultant = false;                      ///< combine two or three directions: sqrt(x^2 + y^2 + z^2)
  bool bridge_gaps = false;                    ///< take straight lines where samples are missing
  /// For accelerations in volts, one for all or one for each in their order (channels: X, Y, Z); empty if
  /// none is.
  std::vector<Sensitivity> sensitivity = {};
  /// The sampling interval of a table without times, s, > 0; the first is at 0. Ignores a column of times.
  std::optional<double> interval = {};
  CutTimes cut = {};
};

/// Reads a pulse. Units are never guessed. Repairs are remarks. Gaps in rows, gaps in times unless they are
/// to be bridged, text, numbers that are not finite, times that do not increase and ambiguous choices are
/// faults, of which the first 200 are reported. At most 1 GiB and 50 million samples.
Reading<PulseFile> read_pulse_csv(const std::filesystem::path& file, const PulseOptions& given);

/// The columns with the units of the header; without a header, numbers only.
Reading<std::vector<injury::MeasuredColumn>> pulse_csv_columns(const std::filesystem::path& file);

/// Column headers, with or without units, and what the headers do not state.
struct StressStrainColumns {
  std::string strain = {};               ///< or a displacement; empty for the column that looks like one
  std::string stress = {};               ///< or a force; empty likewise
  std::string time = {};                 ///< empty for a table without times
  std::string strain_unit = {};          ///< "fraction", "percent" or a length; empty for that of the header
  std::string stress_unit = {};          ///< a pressure or a force; empty for that of the header
  std::string time_unit = {};            ///< empty for that of the header
  std::optional<double> thickness = {};  ///< m, of the specimen; for a displacement
  std::optional<double> area = {};       ///< m2, of the specimen; for a force
};

struct StrainTable {
  std::vector<double> time = {};          ///< s, increasing
  std::vector<double> strain = {};        ///< the first is 0, all in [0, 1)
  std::vector<std::string> remarks = {};  ///< interpretations, a sentence each
};

/// Reads a strain history: a column of strain, or of a displacement if `wanted` has a thickness, and one of
/// times. 2 to 10,000 rows, beginning with strain 0. Compression that is negative is turned positive, with a
/// remark. Reports all faults with their lines, or the first 200.
Reading<StrainTable> read_strain_csv(const std::filesystem::path& file,
                                     const StressStrainColumns& wanted = {});

struct StressStrainTable {
  std::vector<double> time = {};          ///< s, increasing; empty without a column of times
  std::vector<double> strain = {};        ///< engineering strain, below 1; noise may make it negative
  std::vector<double> stress = {};        ///< Pa
  std::vector<std::string> remarks = {};  ///< interpretations, a sentence each
};

/// The header of a table of compression tests.
struct TestHeader {
  struct Stress {
    std::string name;
    double rate = 0;  ///< 1/s; 0: not stated
  };
  std::vector<Stress> stresses;  ///< several only if each has its rate
  std::string time = {};         ///< the only column of times; empty without one
};

/// Reads the header alone. Faults as in read_stress_strain_csv().
Reading<TestHeader> read_test_header(const std::filesystem::path& file, const StressStrainColumns& wanted);

/// Reads a compression test with a header and 2 to 10,000 rows. Compression that is negative in the file is
/// turned positive, with a remark. Reports all faults with their lines, or the first 200: missing columns or
/// units, times that do not increase, strains of 1 or more (per cent taken for a fraction).
Reading<StressStrainTable> read_stress_strain_csv(const std::filesystem::path& file,
                                                  const StressStrainColumns& wanted);

}  // namespace dashpad::input
