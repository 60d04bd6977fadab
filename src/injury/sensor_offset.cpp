#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/measured_pulse.hpp"
#include "quantities/text.hpp"

namespace dashpad::injury {
namespace {

using Directions = std::span<const std::vector<double>>;

constexpr std::size_t fewest_samples = 10;
constexpr double surely_impact = 0.1;   // of the largest deviation
constexpr double min_departure = 5e-3;  // of the largest deviation
constexpr double departure = 5;         // of the scatter
constexpr double left_out = 0.25;       // of the time from the beginning of the impact to its peak
constexpr double near_gravity = 0.1;    // of it: the step from rest to fall
constexpr double clear_split = 1.5;     // of the scatter in both; a sine and its mean have 1.41
constexpr double surely_split = 5;      // of the standard error of the step
constexpr double min_slope = 0.25;      // of the step, between the halves: more is a ramp, no level

Directions directions(const MeasuredPulse& measured) {
  if (measured.components.empty()) return {&measured.pulse.acceleration, 1};
  return measured.components;
}

double length(const std::vector<double>& vector) {
  double sum = 0;
  for (const double each : vector) sum = std::hypot(sum, each);
  return sum;
}

/// The offset over the samples [first, last).
SensorOffset offset_of(const MeasuredPulse& measured, std::size_t first, std::size_t last) {
  SensorOffset offset{
      .begin = measured.pulse.time[first], .end = measured.pulse.time[last - 1], .samples = last - first};
  const auto count = static_cast<double>(offset.samples);
  for (const std::vector<double>& direction : directions(measured)) {
    const auto samples = std::span(direction).subspan(first, offset.samples);
    // Relative to the first sample, so that a constant has no rounding error.
    double sum = 0, squares = 0;
    for (const double value : samples) sum += value - samples.front();
    const double mean = samples.front() + sum / count;
    for (const double value : samples) squares += (value - mean) * (value - mean);
    offset.mean.push_back(mean);
    offset.scatter.push_back(std::sqrt(squares / (count - 1)));
  }
  return offset;
}

double step_between(const SensorOffset& from, const SensorOffset& to) {
  double step = 0;
  for (std::size_t i = 0; i < to.mean.size(); ++i) step = std::hypot(step, to.mean[i] - from.mean[i]);
  return step;
}

/// The sample that best splits [0, last) into two levels, with the least squares about their means.
std::size_t split_of(Directions all, std::size_t last) {
  std::vector<double> taken_away(last);
  for (const std::vector<double>& direction : all) {
    double whole = 0, before = 0;  // relative to the first sample
    for (std::size_t i = 0; i < last; ++i) whole += direction[i] - direction[0];
    for (std::size_t i = 0; i < last; ++i) {
      const auto n = static_cast<double>(i), m = static_cast<double>(last - i);
      if (i >= fewest_samples && last - i >= fewest_samples)
        taken_away[i] += n * m / (n + m) * std::pow((whole - before) / m - before / n, 2);
      before += direction[i] - direction[0];
    }
  }
  return static_cast<std::size_t>(std::ranges::max_element(taken_away) - taken_away.begin());
}

/// The offset over the samples [0, last) or, if they show a rest and a fall, over the fall.
SensorOffset offset_of_quiet_part(const MeasuredPulse& measured, std::size_t last) {
  const std::size_t split = split_of(directions(measured), last);
  if (split < fewest_samples) return offset_of(measured, 0, last);
  const SensorOffset rest = offset_of(measured, 0, split);
  SensorOffset fall = offset_of(measured, split, last);
  const std::size_t middle = split + fall.samples / 2;
  const double scatter = std::hypot(length(rest.scatter), length(fall.scatter)) / std::numbers::sqrt2;
  const double step = step_between(rest, fall);
  const double clear_step =
      surely_split * scatter *
      std::sqrt(1.0 / static_cast<double>(rest.samples) + 1.0 / static_cast<double>(fall.samples));
  const double slope = step_between(offset_of(measured, split, middle), offset_of(measured, middle, last));
  if (std::abs(step - standard_gravity) > near_gravity * standard_gravity || step < clear_split * scatter ||
      step < clear_step || slope > min_slope * step)
    return offset_of(measured, 0, last);
  fall.rest = {rest.end, rest.mean};
  return fall;
}

double deviation(Directions all, const std::vector<double>& from, std::size_t sample) {
  double sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) sum = std::hypot(sum, all[i][sample] - from[i]);
  return sum;
}

std::vector<double> median_at_begin(Directions all) {
  std::vector<double> medians;
  for (const std::vector<double>& direction : all) {
    std::vector<double> begin(direction.begin(), direction.begin() + fewest_samples);
    std::ranges::nth_element(begin, begin.begin() + fewest_samples / 2);
    medians.push_back(begin[fewest_samples / 2]);
  }
  return medians;
}

}  // namespace

SensorOffset offset_between(const MeasuredPulse& measured, double begin, double end) {
  const std::vector<double>& time = measured.pulse.time;
  const auto first = std::ranges::lower_bound(time, begin);
  const auto last = std::ranges::upper_bound(time, end);
  if (last - first < 2) throw std::invalid_argument("contains fewer than two samples");
  return offset_of(measured, static_cast<std::size_t>(first - time.begin()),
                   static_cast<std::size_t>(last - time.begin()));
}

std::optional<SensorOffset> offset_before_impact(const MeasuredPulse& measured) {
  const Directions all = directions(measured);
  const std::vector<double>& time = measured.pulse.time;
  if (time.size() < 2 * fewest_samples) return std::nullopt;
  const std::vector<double> at_begin = median_at_begin(all);
  double largest = 0;
  std::size_t peak = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (const double here = deviation(all, at_begin, i); here > largest) {
      largest = here;
      peak = i;
    }
  std::size_t impact = 0;
  while (impact < peak && deviation(all, at_begin, impact) <= surely_impact * largest) ++impact;
  while (true) {
    const double end = time[impact] - left_out * (time[peak] - time[impact]);
    const auto count = static_cast<std::size_t>(std::ranges::lower_bound(time, end) - time.begin());
    if (count < fewest_samples) return std::nullopt;
    SensorOffset offset = offset_of_quiet_part(measured, count);
    const double noise = departure * length(offset.scatter);
    if (noise > surely_impact * largest) return std::nullopt;
    const std::size_t before = impact;
    while (impact > 0 && deviation(all, offset.mean, impact - 1) > std::max(noise, min_departure * largest))
      --impact;
    if (impact == before) return offset;
  }
}

namespace {

/// Removes the samples before `begin`, s, and adds a remark.
void leave_out_before(MeasuredPulse& measured, double begin) {
  std::vector<double>& time = measured.pulse.time;
  const auto count = std::ranges::lower_bound(time, begin) - time.begin();
  measured.remarks.push_back(
      fmt::format("the first {} samples, up to {} ms, differ by 1 g from those in the fall before the "
                  "impact, as if recorded at rest; they were left out",
                  count, brief(1e3 * time[static_cast<std::size_t>(count - 1)])));
  const auto leave_out = [count](std::vector<double>& values) {
    values.erase(values.begin(), values.begin() + count);
  };
  leave_out(time);
  leave_out(measured.pulse.acceleration);
  for (std::vector<double>& component : measured.components) leave_out(component);
}

}  // namespace

std::optional<SensorOffset> find_offset(MeasuredPulse& measured,
                                        const std::optional<std::pair<double, double>>& interval,
                                        bool is_required) {
  std::optional<SensorOffset> offset = offset_before_impact(measured);
  if (is_required && !interval && !offset)
    throw std::invalid_argument(
        "there is no quiet part before the impact; give an interval, such as \"0 ms,5 ms\"");
  const std::optional<double> begin = offset && offset->rest ? std::optional{offset->begin} : std::nullopt;
  if (interval) try {
      offset = offset_between(measured, interval->first, interval->second);
    } catch (const std::invalid_argument& error) {
      const std::vector<double>& time = measured.pulse.time;
      throw std::invalid_argument(fmt::format("{}; the record runs from {:.6g} to {:.6g} ms", error.what(),
                                              1e3 * time.front(), 1e3 * time.back()));
    }
  if (begin) leave_out_before(measured, *begin);
  return offset;
}

MeasuredPulse zeroed(MeasuredPulse measured, const SensorOffset& offset) {
  const auto take_off = [](std::vector<double>& values, double mean) {
    for (double& value : values) value -= mean;
  };
  for (std::size_t i = 0; i < measured.components.size(); ++i)
    take_off(measured.components[i], offset.mean[i]);
  if (measured.components.empty())
    take_off(measured.pulse.acceleration, offset.mean.front());
  else
    measured.pulse.acceleration = resultant_of(measured.components);
  return measured;
}

}  // namespace dashpad::injury
