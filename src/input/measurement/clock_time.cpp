#include "input/measurement/clock_time.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "input/measurement/measurement_text.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {

namespace {

constexpr double far = 1000;            // of the record
constexpr std::size_t max_digits = 18;  // of a whole part: all of them fit into 64 bits
constexpr std::string_view digits = "0123456789";
constexpr std::size_t longest_time_of_day = 60;
constexpr int seconds_of_hour = 3600, seconds_of_day = 24 * seconds_of_hour;

/// The numbers between separators, without signs and blanks; empty if any is none.
std::vector<int> numbers_between(std::string_view text, char separator) {
  std::vector<int> numbers;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view digit = text.substr(0, end);
    const auto number = digit.size() <= 4 ? parsed<int>(digit) : std::nullopt;
    if (!number || *number < 0) return {};
    numbers.push_back(*number);
    if (end == text.size()) return numbers;
    text.remove_prefix(end + 1);
  }
}

/// Days since 1970; 0 for a date whose day and month may be exchanged. Absent for other text.
std::optional<std::int64_t> days_of(std::string_view text) {
  for (const char separator : {'-', '/', '.'}) {
    const std::vector<int> parts = numbers_between(text, separator);
    if (parts.size() != 3) continue;
    const bool year_first = text.find(separator) == 4;
    if (!year_first && separator == '/') return 0;
    const int year = year_first ? parts[0] : parts[2], first_of_day = year_first ? parts[2] : parts[0];
    const std::chrono::year_month_day date{std::chrono::year{year},
                                           std::chrono::month{static_cast<unsigned>(parts[1])},
                                           std::chrono::day{static_cast<unsigned>(first_of_day)}};
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_days{date}.time_since_epoch().count();
  }
  return std::nullopt;
}

/// Zones by name, longer names before those that they end in, with their lead over UTC in hours; "Uhr" is
/// German for o'clock.
constexpr std::pair<std::string_view, int> zones[]{
    {"CEST", 2}, {"EEST", 3}, {"MESZ", 2}, {"CET", 1},  {"EET", 2},  {"MEZ", 1},  {"WET", 0},
    {"BST", 1},  {"EST", -5}, {"EDT", -4}, {"CST", -6}, {"CDT", -5}, {"MST", -7}, {"MDT", -6},
    {"PST", -8}, {"PDT", -7}, {"JST", 9},  {"UTC", 0},  {"GMT", 0},  {"Uhr", 0},  {"Z", 0}};

/// Takes a zone off the end, "Z", "CEST", "+02:00", "+0200": its lead over UTC, s. A hyphen in a date is
/// none.
int take_zone(std::string_view& text) {
  for (const auto& [name, hours] : zones)
    if (text.ends_with(name)) {
      text = without_blanks(text.substr(0, text.size() - name.size()));
      return hours * seconds_of_hour;
    }
  const std::size_t sign = text.find_last_of("+-");
  if (sign == std::string_view::npos || sign < text.find(':')) return 0;
  const std::string_view zone = text.substr(sign + 1);
  std::vector<int> parts = numbers_between(zone, ':');
  if (parts.size() == 1 && zone.size() == 4) parts = {parts[0] / 100, parts[0] % 100};
  if (parts.empty() || parts.size() > 2 || parts[0] > 14) return 0;
  const int lead = parts[0] * seconds_of_hour + (parts.size() == 2 ? parts[1] * 60 : 0);
  const bool is_behind = text[sign] == '-';
  text = without_blanks(text.substr(0, sign));
  return is_behind ? -lead : lead;
}

/// Takes "AM" or "p.m." off the end: the hours that it adds to the hour that is written.
std::optional<int> take_half_of_day(std::string_view& text) {
  const std::size_t begin = std::min(text.find_last_of("0123456789 ") + 1, text.size());
  std::string end = upper_case(text.substr(begin));
  std::erase(end, '.');
  if (end != "AM" && end != "PM") return std::nullopt;
  text = without_blanks(text.substr(0, begin));
  return end == "PM" ? 12 : 0;
}

}  // namespace

std::optional<ExactTime> time_of_day(std::string_view text) {
  text = without_blanks(text);
  if (text.size() > longest_time_of_day || text.find(':') == std::string_view::npos) return std::nullopt;
  const int lead = take_zone(text);
  const std::optional<int> half = take_half_of_day(text);
  std::int64_t days = 0;
  if (const std::size_t between = text.substr(0, text.find(':')).find_last_of("T ");
      between != std::string_view::npos) {
    const auto date = days_of(without_blanks(text.substr(0, between)));
    if (!date) return std::nullopt;
    days = *date;
    text.remove_prefix(between + 1);
  }
  const std::size_t last = text.rfind(':');
  std::vector<int> parts = numbers_between(text.substr(0, last), ':');
  const std::string_view seconds = text.substr(last + 1);
  const bool has_fraction = seconds.find_first_of(".,") != std::string_view::npos;
  if (parts.size() == 1 && has_fraction) parts.insert(parts.begin(), 0);
  const std::optional<ExactTime> exact = seconds.find_first_not_of("0123456789.,") == std::string_view::npos
                                             ? exact_time(seconds)
                                             : std::nullopt;
  if (parts.size() != 2 || !exact || exact->whole > 60 || parts[1] > 59 || parts[0] > 24) return std::nullopt;
  if (half && (parts[0] < 1 || parts[0] > 12)) return std::nullopt;
  const int hours = half ? parts[0] % 12 + *half : parts[0];
  return ExactTime{days * seconds_of_day + hours * seconds_of_hour + parts[1] * 60 - lead + exact->whole,
                   exact->part};
}

bool RunningClock::read(std::string_view text) {
  std::optional<ExactTime> time = time_of_day(text);
  if (!time) return false;
  const std::int64_t round = std::ranges::count(text, ':') == 1 ? seconds_of_hour : seconds_of_day;
  const bool has_date = time->whole >= 2 * seconds_of_day;
  time->whole += rounds_ * round;
  if (!has_date && has_begun_ && time->whole + round / 2 < time_.whole) {
    ++rounds_;
    time->whole += round;
  }
  has_begun_ = true;
  time_ = *time;
  return true;
}

std::optional<ExactTime> exact_time(std::string_view number) {
  number = without_blanks(number);
  const bool is_negative = number.starts_with('-');
  if (is_negative || number.starts_with('+')) number.remove_prefix(1);
  const std::size_t mantissa_end = std::min(number.find_first_of("eE"), number.size());
  int exponent = 0;
  if (mantissa_end < number.size()) {
    std::string_view text = number.substr(mantissa_end + 1);
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto whole = parsed<int>(text);
    if (!whole) return std::nullopt;
    exponent = *whole;
  }
  const std::string_view mantissa = number.substr(0, mantissa_end);
  const std::size_t point = std::min(mantissa.find_first_of(".,"), mantissa.size());
  std::string all(mantissa.substr(0, point));
  if (point < mantissa.size()) all += mantissa.substr(point + 1);
  if (all.empty() || all.find_first_not_of(digits) != std::string::npos) return std::nullopt;
  // The place of the decimal point among the digits; beyond their ends there are zeros.
  const std::int64_t place = static_cast<std::int64_t>(point) + exponent;
  if (place > static_cast<std::int64_t>(max_digits)) return std::nullopt;
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
      "the times begin at {}, far beyond the length of the record; Dashpad counts them from the "
      "first sample",
      first);
}

}  // namespace dashpad::input
