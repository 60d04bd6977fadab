#pragma once
/// The 33 validation tests of the report's Table 3-1, in its units, as far as the scan is legible.
///
/// Readings whose order in a column the scan shows, but not their tests, are kept as separate groups.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::report1986 {

enum class Projectile { aluminium, steel };
enum class TestSupport { load_cell, plate };

/// One row of Table 3-1. A value is absent if it was not measured or its row is uncertain.
struct MeasuredTest {
  int number = 0;
  Projectile projectile = Projectile::aluminium;
  double weight_lb = 0;
  TestSupport support = TestSupport::load_cell;
  double speed_mph = 0;
  double energy_in_lb = 0;
  std::optional<double> rebound_mph = {};
  std::optional<double> time_to_peak_ms = {};
  std::optional<double> total_time_ms = {};
  std::optional<double> peak_force_lb = {};
  std::optional<double> plug_strain = {};      ///< by the clay plug
  std::optional<double> diameter_strain = {};  ///< by the contact diameter
};

/// The peak strain of a test: the mean of both methods if both were used (report, section 3.3).
std::optional<double> peak_strain(const MeasuredTest& test);

/// Readings of one column whose tests are lost. In this order, they belong to some of the tests from first to
/// last that have no certain reading in that column.
struct UnplacedReadings {
  std::string column;  ///< as in the data file: "rebound_mph", "peak_force_lb", ...
  int first_test = 0;
  int last_test = 0;
  std::vector<double> readings;
};

struct MeasuredTests {
  std::vector<MeasuredTest> tests;  ///< by number
  std::vector<UnplacedReadings> unplaced;
};

/// A point of a support's static curve.
struct StaticPoint {
  double deflection_in = 0;
  double force_lb = 0;
};

/// A constant that the report prints, with its name in the data file: "travel_in" (VT = 1.65 in), ...
struct PrintedConstant {
  std::string name;
  double value = 0;
  std::string unit;
  std::string where;  ///< in the report
};

/// A column of the report's Table 3-2.
struct ExpectationExample {
  Projectile projectile = Projectile::steel;
  double speed_mph = 0, energy_in_lb = 0, peak_force_lb = 0, rebound_energy_in_lb = 0,
         support_energy_in_lb = 0;
  double speed_ratio = 0;  ///< V_R*/V
  double rebound_mph = 0;  ///< V_R*
};

/// All data that the study reads from files.
struct ValidationData {
  MeasuredTests measured;
  std::vector<StaticPoint> load_cell;  ///< after the origin; a reconstruction (data/validation/README.md)
  double plate_stiffness_lb_per_in = 0;
  double pad_thickness_in = 0;
  std::vector<PrintedConstant> printed;
  std::vector<ExpectationExample> table_3_2;
  std::vector<input::InputFile> files;  ///< all files that were read, valid or not

  /// The value of a printed constant. Throws std::out_of_range with its name if there is none.
  [[nodiscard]] double constant(const std::string& name) const;
};

/// Reads table-3-1.csv, table-3-1-unplaced.csv, table-3-2.csv, printed-constants.csv and supports.csv in a
/// folder. Adds all faults to `faults`, with file, line, column, value and rule; the data are valid only if
/// there are none.
ValidationData read_validation_data(const std::filesystem::path& folder, std::vector<input::Fault>& faults);

const char* to_string(Projectile projectile);
const char* to_string(TestSupport support);  ///< "load cell", "flexible plate"

}  // namespace dashpad::report1986
