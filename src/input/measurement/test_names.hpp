#pragma once
/// The columns of compression tests as their headers name them.

#include <cstddef>
#include <string>
#include <vector>

#include "input/measurement/csv_table.hpp"

namespace dashpad::input {

enum class TestKind { strain, displacement, stress, force, time, other };

/// A column with the parts of its header: "stress", "kPa" and "10 1/s" of "stress_kPa @ 10 1/s".
struct TestColumn {
  injury::MeasuredColumn of;         ///< with its unit
  std::string name = {}, rate = {};  ///< the name in lower case
  TestKind kind = TestKind::other;
};

/// The columns of the row that names most of a test, with units from it or from a row of units below; `line`
/// becomes that of the row. Empty without such a row.
std::vector<TestColumn> named_test_columns(const CsvHeader& header, std::size_t& line);

/// The unit of a force for that of a mass, whose weight it is: "gf" for "g".
std::string unit_of_weight(const std::string& unit);

bool is_unit_of_dimension(const std::string& unit, const char* si_unit);

}  // namespace dashpad::input
