#pragma once
/// Table 3-1 in two files: the certain rows, and the readings whose rows are lost.

#include <filesystem>
#include <vector>

#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

/// Also checks that each energy is M V^2/2, that a rebound is slower than the impact, that a peak comes
/// before the end.
std::vector<MeasuredTest> read_certain_rows(const std::filesystem::path& file,
                                            std::vector<input::Fault>& faults);

/// Also checks that the groups fit in the rows: tests that exist and have no reading of their own, enough of
/// them, and each claimed by one group of its column only.
std::vector<UnplacedReadings> read_unplaced(const std::filesystem::path& file,
                                            const std::vector<MeasuredTest>& tests,
                                            std::vector<input::Fault>& faults);

}  // namespace dashpad::report1986
