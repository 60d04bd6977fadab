#pragma once
/// The measured columns of Table 3-1, and all ways of assigning lost readings, in their order, to tests.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation/verdict.hpp"

namespace dashpad::report1986 {

struct MeasuredColumn {
  const char* name;  ///< in the data files
  std::optional<double> MeasuredTest::*reading;
  const char* words;                 ///< for people, with the unit
  std::optional<Quantity> quantity;  ///< of the rules, if it is one
  [[nodiscard]] bool is_fraction() const { return quantity == Quantity::peak_strain; }
};

inline constexpr std::array<MeasuredColumn, 6> measured_columns{{
    {"rebound_mph", &MeasuredTest::rebound_mph, "rebound speed (mph)", Quantity::rebound_speed},
    {"time_to_peak_ms", &MeasuredTest::time_to_peak_ms, "time to peak (ms)", Quantity::time_to_peak},
    {"total_time_ms", &MeasuredTest::total_time_ms, "duration (ms)", {}},
    {"peak_force_lb", &MeasuredTest::peak_force_lb, "peak force (lb)", Quantity::peak_force},
    {"plug_strain", &MeasuredTest::plug_strain, "peak strain, clay plug", Quantity::peak_strain},
    {"diameter_strain", &MeasuredTest::diameter_strain, "peak strain, contact diameter",
     Quantity::peak_strain},
}};

/// The column of that name. Throws std::out_of_range if there is none.
const MeasuredColumn& measured_column(const std::string& name);

/// The tests in the group's range that have no reading of their own in its column, by number.
std::vector<const MeasuredTest*> free_tests(const MeasuredTests& measured, const UnplacedReadings& group);

/// The number of ways to choose `readings` of `rows`; 0 if there are more readings than rows.
double placings(std::size_t rows, std::size_t readings);

/// The product over all groups of a column.
double placings(const MeasuredTests& measured, const std::string& column);

/// Calls `visit` with all tests for each placing of the unplaced readings of a column. Throws
/// std::length_error for more than a million.
void for_each_placing(const MeasuredTests& measured, const std::string& column,
                      const std::function<void(const std::vector<MeasuredTest>&)>& visit);

}  // namespace dashpad::report1986
