#pragma once
/// The columns of compression tests: strain or displacement, stress or force, time, by their headers.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/measurement/tables.hpp"
#include "input/measurement/csv_table.hpp"

namespace dashpad::input {

struct StressColumn {
  injury::MeasuredColumn of;  ///< its factor gives Pa, of a force over the area of the specimen
  double rate = 0;            ///< 1/s, in the header after an @; 0: not stated
};

/// Rows of a test, at most; some readers allow fewer.
inline constexpr std::size_t max_rows_of_stresses = 100'000;

struct TestColumns {
  std::size_t line = 0;           ///< of the header
  injury::MeasuredColumn strain;  ///< its factor gives a strain, of a displacement over the thickness
  bool is_displacement = false;   ///< the strain
  double zero = 0;                ///< of a displacement, in the unit of the file
  std::size_t first_line = 0;     ///< of the rows that count; those before are an approach without force
  std::vector<StressColumn> stresses = {};
  std::optional<injury::MeasuredColumn> time = {};
};

/// What to look for beside a strain.
enum class Beside { one_stress, stresses, time };

/// Finds the columns by `wanted` or by names in English, German, French, Spanish and Italian, and by units.
/// Faults that name the option that helps if a header is ambiguous or lacks a unit. Throws InputError.
TestColumns find_test_columns(const CsvHeader& header, const StressStrainColumns& wanted, Beside beside,
                              MeasurementFaults& faults);

/// Lets a displacement that begins elsewhere than at 0, without load, count from where the force begins, and
/// leaves out the rows before. Remarks on it, on a force that is not 0 at the beginning, and on numbers above
/// the header.
void settle_beginning(const CsvTable& csv, TestColumns& columns, std::vector<std::string>& remarks);

/// The strain in a row; absent after a fault. 70 % and 17.5 mm of 25 mm are 0.7 to the last digit.
std::optional<double> strain_in(const CsvRow& row, const TestColumns& columns, MeasurementFaults& faults);

/// The rule for a strain of 1 or more.
std::string too_large_strain(const TestColumns& columns);

/// Turns the signs of values that are compressive and negative; a remark says so.
void make_compression_positive(std::vector<double>& values, const std::string& name,
                               std::vector<std::string>& remarks);

}  // namespace dashpad::input
