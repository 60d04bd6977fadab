#pragma once
/// The ways to give readings, in their order, to tests.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

/// How many ways there are to choose `readings` of `rows`; 0 where there are more readings than rows. As a
/// double, since it may be large.
double placings(std::size_t rows, std::size_t readings);

/// Of all groups of a column together.
double placings(const MeasuredTests& measured, const std::string& column);

/// More are not gone through.
inline constexpr double most_placings = 1e6;

/// Calls `visit` with all tests, once for each placing of all unplaced readings of a column. Throws
/// std::length_error where there are more than most_placings.
void for_each_placing(const MeasuredTests& measured, const std::string& column,
                      const std::function<void(const std::vector<MeasuredTest>&)>& visit);

}  // namespace dashpad::report1986
