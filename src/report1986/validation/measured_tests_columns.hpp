#pragma once
/// The measured columns of Table 3-1, by their names in the data files.

#include <array>
#include <optional>
#include <string>

#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

struct MeasuredColumn {
  const char* name;
  std::optional<double> MeasuredTest::*reading;
  bool is_fraction;  ///< a strain
};

inline constexpr std::array<MeasuredColumn, 6> measured_columns{{
    {"rebound_mph", &MeasuredTest::rebound_mph, false},
    {"time_to_peak_ms", &MeasuredTest::time_to_peak_ms, false},
    {"total_time_ms", &MeasuredTest::total_time_ms, false},
    {"peak_force_lb", &MeasuredTest::peak_force_lb, false},
    {"plug_strain", &MeasuredTest::plug_strain, true},
    {"diameter_strain", &MeasuredTest::diameter_strain, true},
}};

/// The column of a group. Throws std::out_of_range for a name that is none.
const MeasuredColumn& measured_column(const std::string& name);

/// The tests of the group's range that have no reading of their own in its column, by number.
std::vector<const MeasuredTest*> free_tests(const MeasuredTests& measured, const UnplacedReadings& group);

}  // namespace dashpad::report1986
