// The part of a measured pulse that a fit has to meet.

#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"

namespace dashpad::fit {

namespace {

constexpr std::size_t fewest_samples = 5;  ///< between onset and end

}  // namespace

MeasuredDeceleration deceleration_of(const Pulse& measured, const std::optional<injury::Stretch>& quiet) {
  const injury::PulseShape shape =
      injury::pulse_shape(measured, std::nullopt, injury::contact_of(measured, quiet));
  if (!shape.onset)
    throw std::invalid_argument(
        fmt::format("its first sample is above {:.0f} % of its peak already, so that its onset is not in it",
                    100 * injury::onset_share));
  MeasuredDeceleration result;
  result.peak = shape.peak.magnitude;
  result.onset = *shape.onset;
  result.half_peak_width = shape.width;
  result.interval =
      (measured.time.back() - measured.time.front()) / static_cast<double>(measured.time.size() - 1);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < measured.time.size(); ++i)
    if (measured.time[i] >= *shape.onset && measured.time[i] <= shape.contact.end) kept.push_back(i);
  if (kept.size() < fewest_samples)
    throw std::invalid_argument(fmt::format("has {} samples between its onset and its end; a fit needs {}",
                                            kept.size(), fewest_samples));
  result.samples = kept.size();
  Pulse between;
  for (const std::size_t i : kept) {
    between.time.push_back(measured.time[i]);
    between.acceleration.push_back(measured.acceleration[i]);
  }
  result.hic = injury::hic(between, injury::unlimited_window).value;
  result.velocity_change = shape.contact.velocity_change;
  const std::size_t points = std::min(kept.size(), most_pulse_points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t i = kept[k * (kept.size() - 1) / (points - 1)];
    result.time.push_back(measured.time[i] - *shape.onset);
    result.deceleration.push_back(shape.side * measured.acceleration[i]);
  }
  return result;
}

}  // namespace dashpad::fit
