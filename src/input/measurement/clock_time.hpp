#pragma once
/// Times of clocks: those that began long ago, and times of day.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dashpad::input {

/// A decimal number as its whole part and its decimals, of the same sign. A double cannot hold
/// 1764068400.1234 s to better than 0.24 us; so times of such clocks are subtracted before they are rounded.
struct ExactTime {
  std::int64_t whole = 0;
  double part = 0;  ///< in (-1, 1)

  /// The difference to `first`, accurate to 1e-16 for near times.
  [[nodiscard]] double since(const ExactTime& first) const {
    return static_cast<double>(whole - first.whole) + (part - first.part);
  }
};

/// A number with a decimal point or comma, as in read_csv_number(); absent beyond 18 digits before the point.
std::optional<ExactTime> exact_time(std::string_view number);

/// A time of day, s after midnight, or with a date s after 1970 began: "10:00:00.0001", "10:00:00,0001",
/// "59:59.9" (minutes and seconds), "2:03:04 PM", "2024-05-01T10:00:00Z", "2024/05/01 10:00:00+02:00",
/// "01.05.2024 10:00:00". Zones are taken off. A date such as 05/01/2024 may be May or January and is not
/// used. Absent for other text.
std::optional<ExactTime> time_of_day(std::string_view text);

/// Times of day, row by row. Without a date, the clock begins anew at midnight, and one of minutes and
/// seconds at the full hour.
class RunningClock {
 public:
  /// False for a text that is no time of day.
  bool read(std::string_view text);
  /// The latest time, with the rounds of the clock since the first.
  [[nodiscard]] const ExactTime& time() const { return time_; }

 private:
  ExactTime time_ = {};
  std::int64_t rounds_ = 0;
  bool has_begun_ = false;
};

/// Whether times count from the first sample: the clock's zero is further away than a thousand times
/// `length`, s, of the record.
bool counts_from_first(double first, double length);

/// The remark for such a record. `first` is as in the file, with its unit.
std::string remark_on_clock(const std::string& first);

}  // namespace dashpad::input
