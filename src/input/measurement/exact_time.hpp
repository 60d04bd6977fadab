#pragma once
/// Times of a clock that began long ago: 1764068400.1234 s has no room for a sample of 0.1 ms in a double,
/// whose steps are 0.24 us there. So they are subtracted before they are rounded.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dashpad::input {

/// A decimal number as its whole part and what is behind the point, of the same sign.
struct ExactTime {
  std::int64_t whole = 0;
  double part = 0;  ///< in (-1, 1)

  /// This less `first`, rounded once the common part is gone: to 1e-16 where both are near.
  [[nodiscard]] double since(const ExactTime& first) const {
    return static_cast<double>(whole - first.whole) + (part - first.part);
  }
};

/// Of a number with a decimal point or comma, as read_csv_number() takes it; absent for one with more than 18
/// digits before the point.
std::optional<ExactTime> exact_time(std::string_view number);

/// Whether a record of `length`, s, counts from its first sample: where its clock began more than a thousand
/// times as long ago, or will begin so much later.
bool counts_from_first(double first, double length);

/// What the user is told then. `first` is as in the file, with its unit.
std::string remark_on_clock(const std::string& first);

}  // namespace dashpad::input
