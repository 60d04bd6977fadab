#include "dashpad/input/measurement/sensor_offset.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace dashpad::input {

namespace {

constexpr std::size_t fewest_samples = 10;
constexpr double surely_impact = 0.1;     // of the largest deviation
constexpr double least_departure = 5e-3;  // the same
constexpr double departure = 5;           // of the scatter
constexpr double margin = 0.25;           // of the time from the beginning of the impact to its peak

using Directions = std::span<const std::vector<double>>;

Directions directions(const MeasuredPulse& measured) {
  if (measured.components.empty()) return {&measured.pulse.acceleration, 1};
  return measured.components;
}

double length(const std::vector<double>& vector) {
  double sum = 0;
  for (const double each : vector) sum = std::hypot(sum, each);
  return sum;
}

/// Of the samples [first, last).
SensorOffset offset_of(const MeasuredPulse& measured, std::size_t first, std::size_t last) {
  SensorOffset offset{
      .begin = measured.pulse.time[first], .end = measured.pulse.time[last - 1], .samples = last - first};
  const auto count = static_cast<double>(offset.samples);
  for (const std::vector<double>& direction : directions(measured)) {
    const auto samples = std::span(direction).subspan(first, offset.samples);
    // From the first sample on, so that a constant is its own mean without rounding.
    double sum = 0, squares = 0;
    for (const double value : samples) sum += value - samples.front();
    const double mean = samples.front() + sum / count;
    for (const double value : samples) squares += (value - mean) * (value - mean);
    offset.mean.push_back(mean);
    offset.scatter.push_back(std::sqrt(squares / (count - 1)));
  }
  return offset;
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
  if (last - first < 2) throw std::invalid_argument("holds fewer than two samples");
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
    const double end = time[impact] - margin * (time[peak] - time[impact]);
    const auto count = static_cast<std::size_t>(std::ranges::lower_bound(time, end) - time.begin());
    if (count < fewest_samples) return std::nullopt;
    SensorOffset offset = offset_of(measured, 0, count);
    const double noise = departure * length(offset.scatter);
    if (noise > surely_impact * largest) return std::nullopt;
    const std::size_t before = impact;
    while (impact > 0 && deviation(all, offset.mean, impact - 1) > std::max(noise, least_departure * largest))
      --impact;
    if (impact == before) return offset;
  }
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

}  // namespace dashpad::input
