#include "report1986/validation/measured_tests_columns.hpp"

#include <algorithm>
#include <stdexcept>

namespace dashpad::report1986 {

const MeasuredColumn& measured_column(const std::string& name) {
  const auto* const found = std::ranges::find(measured_columns, name, &MeasuredColumn::name);
  if (found == measured_columns.end()) throw std::out_of_range("no measured column is called " + name);
  return *found;
}

std::vector<const MeasuredTest*> free_tests(const MeasuredTests& measured, const UnplacedReadings& group) {
  const MeasuredColumn& column = measured_column(group.column);
  std::vector<const MeasuredTest*> tests;
  for (const MeasuredTest& test : measured.tests)
    if (test.number >= group.first_test && test.number <= group.last_test && !(test.*column.reading))
      tests.push_back(&test);
  return tests;
}

}  // namespace dashpad::report1986
