#include "input/measurement/pulse_samples.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "quantities/from_chars.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {

void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults) {
  if (pulse.time.size() < 2) return;
  const Magnitudes times = measured_magnitudes("s"), accelerations = measured_magnitudes("m/s2");
  const double begin = pulse.time.front(), end = pulse.time.back();
  const double latest = std::max(std::abs(begin), std::abs(end));
  const double step = (end - begin) / static_cast<double>(pulse.time.size() - 1);
  if (!(latest <= times.most))
    faults.add(
        line, "time", "",
        fmt::format("goes to {:.3g} s; must be within {:g} s: is the unit right?", latest, times.most));
  else if (step > 0 && step < times.least)
    faults.add(line, "time", "",
               fmt::format("samples are {:.3g} s apart; must be {:g} s or more, since no sensor is sampled "
                           "faster: is the unit right?",
                           step, times.least));
  double peak = 0;
  for (const double value : pulse.acceleration) peak = std::max(peak, std::abs(value));
  if (!accelerations.admit(peak))
    faults.add(line, "acceleration", "",
               fmt::format("its largest magnitude is {:.3g} m/s2; must be between {:g} and {:g} m/s2, the "
                           "range of impacts: is the unit right?",
                           peak, accelerations.least, accelerations.most));
}

namespace {

constexpr double rounding = 1e-6;  // of times that were written with few digits
constexpr double max_on_even_grid = 1.5 + rounding;
constexpr double evenness = 0.25 + rounding;
constexpr std::size_t few_gaps = 3;
constexpr double max_on_any_grid = 10;
constexpr double max_of_neighbours = 3;

double median_step(const std::vector<double>& times) {
  std::vector<double> steps(times.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = times[i + 1] - times[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

bool is_even_but_for_gaps(const std::vector<double>& times, double usual) {
  const std::size_t count = times.size() - 1;
  std::size_t longer = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = times[i + 1] - times[i];
    if (step > max_on_even_grid * usual)
      ++longer;
    else if (std::abs(step - usual) > evenness * usual)
      return false;
  }
  return 2 * longer < count && (longer <= few_gaps || 10 * longer <= count);
}

constexpr double far = 1000;            // of the record
constexpr std::size_t max_digits = 18;  // of a whole part: all of them fit into 64 bits
constexpr std::string_view digits = "0123456789";

}  // namespace

PulseGaps find_gaps(const std::vector<double>& times) {
  if (times.size() < 4) return {};
  PulseGaps gaps{.usual_step = median_step(times)};
  const bool even = is_even_but_for_gaps(times, gaps.usual_step);
  const double longest = (even ? max_on_even_grid : max_on_any_grid) * gaps.usual_step;
  const std::size_t count = times.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = times[i + 1] - times[i];
    if (!(step > longest)) continue;
    const double before = i > 0 ? times[i] - times[i - 1] : 0;
    const double behind = i + 1 < count ? times[i + 2] - times[i + 1] : 0;
    if (even || step > max_of_neighbours * std::max(before, behind)) gaps.all.push_back({i, step});
  }
  return gaps;
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
      "the times begin at {}, far beyond the length of the record: here they count from the "
      "first sample",
      first);
}

}  // namespace dashpad::input
