#include "output/plot/axis_ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// A logarithmic axis that spans fewer decades than this has the marks of a linear one.
constexpr double few_decades = 0.7;
/// An axis with more decades has marks at powers of ten only; with labels farther apart, at labels only.
constexpr int max_decades_with_digits = 6;
/// The relative rounding error with which a mark still counts as the end of an axis.
constexpr double off_a_mark = 1e-9;
/// Whole numbers above it are not exact.
constexpr double largest_count = 1e15;

/// digit * 10^power, as exact as division allows.
double decimal(double digits, int power) {
  // 10^power itself may be too large or too small for a double where the product is not.
  if (power > 300) return digits * 1e300 * std::pow(10, power - 300);
  if (power < -300) return digits / 1e300 / std::pow(10, -power - 300);
  return power < 0 ? digits / std::pow(10, -power) : digits * std::pow(10, power);
}

struct Step {
  double digit = 1;  ///< 1, 2 or 5
  int power = 0;

  [[nodiscard]] double size() const { return decimal(digit, power); }
  [[nodiscard]] double multiple(double count) const { return decimal(count * digit, power); }
};

/// The least step with which a length has at most so many.
Step step_for(double length, std::size_t most) {
  const double least = length / static_cast<double>(most);
  const int power = static_cast<int>(std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (decimal(digit, power) >= least * (1 - off_a_mark)) return {digit, power};
  return {1, power + 1};
}

double decades(const Span& span) { return std::log10(span.high) - std::log10(span.low); }

bool has_linear_marks(const Span& span, bool logarithmic) {
  return !logarithmic || decades(span) < few_decades;
}

/// A span of at least some length around what has none, so that marks on it differ.
Span widened(Span span, bool logarithmic) {
  constexpr double least = 1e-9;  // least relative length
  if (span.is_empty()) return logarithmic ? Span{1, 10} : Span{0, 1};
  const double size = std::max(std::abs(span.low), std::abs(span.high));
  if (size > 0 && span.high / size - span.low / size > least) return span;
  if (size == 0) return {-1, 1};
  if (logarithmic) return {span.low / 2, span.high * 2};
  return {span.low - size / 10, span.high + size / 10};
}

/// The ends of a linear axis at the next marks, or half way to them.
Span linear_ends(const Span& span, std::size_t most) {
  const Step step = step_for(span.high - span.low, most);
  const double first = std::floor(2 * (span.low / step.size()) + off_a_mark) / 2;
  const double last = std::ceil(2 * (span.high / step.size()) - off_a_mark) / 2;
  if (!(std::max(std::abs(first), std::abs(last)) < largest_count)) return span;
  return {step.multiple(first), step.multiple(last)};
}

std::string superscript(int number) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result = number < 0 ? "⁻" : "";
  for (const char digit : fmt::format("{}", std::abs(number)))
    result += digits[static_cast<std::size_t>(digit - '0')];
  return result;
}

std::string with_minus(std::string number) {
  replace_all(number, "-", "−");
  return number;
}

/// digits * 10^power as it is written: "2×10⁷", "10⁷".
std::string power_label(const std::string& digits, int power) {
  return fmt::format("{}10{}", digits == "1" ? "" : digits + "×", superscript(power));
}

int power_of(double value) { return static_cast<int>(std::floor(std::log10(value) + off_a_mark)); }

/// A multiple of the step, with as many digits as the step needs.
std::string linear_label(double value, const Step& step, double largest) {
  if (value == 0) return "0";
  const int power = power_of(largest);
  if (power <= 6 && step.power >= -6)
    return with_minus(fmt::format("{:.{}f}", value, std::max(0, -step.power)));
  const int digits = std::clamp(power - step.power, 0, 15);
  return with_minus(power_label(fmt::format("{:.{}f}", value / decimal(1, power), digits), power));
}

std::vector<Tick> linear_ticks(const AxisRange& range, std::size_t most) {
  const Step step = step_for(range.high - range.low, most);
  const double first = std::ceil(range.low / step.size() - off_a_mark);
  const double last = std::floor(range.high / step.size() + off_a_mark);
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  std::vector<Tick> ticks;
  if (!(std::max(std::abs(first), std::abs(last)) < largest_count)) {
    for (const double end : {range.low, range.high})
      ticks.push_back({end, with_minus(fmt::format("{}", end))});
    return ticks;
  }
  const auto steps = static_cast<int>(last - first);
  for (int i = 0; i <= steps; ++i) {
    const double value = step.multiple(first + i);
    ticks.push_back({std::clamp(value, range.low, range.high), linear_label(value, step, largest)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const AxisRange& range, std::size_t most) {
  const int first = power_of(range.low), last = power_of(range.high);
  const double length = decades({range.low, range.high});
  const int labelled = std::max(1, static_cast<int>(std::ceil(length / static_cast<double>(most))));
  const bool has_room = 3 * length <= static_cast<double>(most);
  const bool is_plain = range.low > 1.5e-4 && range.high < 7e4;  // short
  const int digits = length <= max_decades_with_digits ? 9 : 1;
  std::vector<Tick> ticks;
  for (int power = first; power <= last; ++power) {
    for (int digit = 1; digit <= digits; ++digit) {
      const double value = decimal(digit, power);
      if (value < range.low * (1 - off_a_mark) || value > range.high * (1 + off_a_mark)) continue;
      const bool is_major = digit == 1 ? power % labelled == 0 : has_room && (digit == 2 || digit == 5);
      if (!is_major && labelled > max_decades_with_digits) continue;
      std::string label;
      if (is_major)
        label = is_plain ? fmt::format("{:.{}f}", value, std::max(0, -power))
                         : power_label(fmt::format("{}", digit), power);
      ticks.push_back({std::clamp(value, range.low, range.high), std::move(label)});
    }
  }
  return ticks;
}

}  // namespace

double AxisRange::share(double value) const {
  if (logarithmic) return (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low));
  // Halves, so that the longest axis has a length, too.
  return (value / 2 - low / 2) / (high / 2 - low / 2);
}

AxisRange range_of(const Axis& axis, const Span& included, std::size_t most) {
  Span span = included;
  if (axis.low) span.low = *axis.low;
  if (axis.high) span.high = *axis.high;
  if (span.is_empty() && axis.low) span.high = span.low;
  if (span.is_empty() && axis.high) span.low = span.high;
  span = widened(span, axis.logarithmic);
  Span ends = has_linear_marks(span, axis.logarithmic)
                  ? linear_ends(span, most)
                  : Span{round_number(span.low, false), round_number(span.high, true)};
  if (axis.logarithmic && !(ends.low > 0)) ends.low = span.low;
  return {axis.low.value_or(ends.low), axis.high.value_or(ends.high), axis.logarithmic};
}

double round_number(double value, bool above) {
  const int power = static_cast<int>(std::floor(std::log10(value)));
  double below = decimal(1, power - 1) * 5;
  for (const auto& [digit, at] : {std::pair{1.0, power}, {2.0, power}, {5.0, power}, {1.0, power + 1}}) {
    const double number = decimal(digit, at);
    if (above && number >= value * (1 - off_a_mark)) return number;
    if (number <= value * (1 + off_a_mark)) below = number;
  }
  return above ? value : below;
}

std::vector<Tick> ticks_of(const AxisRange& range, std::size_t most) {
  return has_linear_marks({range.low, range.high}, range.logarithmic) ? linear_ticks(range, most)
                                                                      : logarithmic_ticks(range, most);
}

}  // namespace dashpad::output
