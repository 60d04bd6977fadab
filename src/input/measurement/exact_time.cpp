#include "input/measurement/exact_time.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "input/measurement/measurement_text.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {

namespace {

constexpr double far = 1000;             // of the record
constexpr std::size_t most_digits = 18;  // of a whole part: all of them fit into 64 bits
constexpr std::string_view digits = "0123456789";

}  // namespace

std::optional<ExactTime> exact_time(std::string_view number) {
  number = without_blanks(number);
  const bool is_negative = number.starts_with('-');
  if (is_negative || number.starts_with('+')) number.remove_prefix(1);
  const std::size_t mantissa_end = std::min(number.find_first_of("eE"), number.size());
  int exponent = 0;
  if (mantissa_end < number.size()) {
    std::string_view text = number.substr(mantissa_end + 1);
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  }
  const std::string_view mantissa = number.substr(0, mantissa_end);
  const std::size_t point = std::min(mantissa.find_first_of(".,"), mantissa.size());
  std::string all(mantissa.substr(0, point));
  if (point < mantissa.size()) all += mantissa.substr(point + 1);
  if (all.empty() || all.find_first_not_of(digits) != std::string::npos) return std::nullopt;
  // The point among all digits; beyond either end there are zeros.
  const std::int64_t place = static_cast<std::int64_t>(point) + exponent;
  if (place > static_cast<std::int64_t>(most_digits)) return std::nullopt;
  const auto whole_digits = static_cast<std::size_t>(std::max<std::int64_t>(place, 0));
  if (whole_digits > all.size()) all.append(whole_digits - all.size(), '0');
  ExactTime time;
  for (const char digit : all.substr(0, whole_digits)) time.whole = 10 * time.whole + (digit - '0');
  const std::string part =
      "0." + all.substr(whole_digits) + "e" + std::to_string(std::min<std::int64_t>(place, 0));
  from_chars(part.data(), part.data() + part.size(), time.part);
  return is_negative ? ExactTime{-time.whole, -time.part} : time;
}

bool counts_from_first(double first, double length) {
  return std::abs(first) > far * length && std::abs(first) <= measured_magnitudes("s").most;
}

std::string remark_on_clock(const std::string& first) {
  return fmt::format(
      "the times begin at {}, far beyond the length of the record: here they count from the "
      "first sample",
      first);
}

}  // namespace dashpad::input
