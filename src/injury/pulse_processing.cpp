#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/injury/pulse_report.hpp"
#include "injury/pulse_line.hpp"
#include "quantities/text.hpp"

namespace dashpad::injury {

std::vector<double> resultant_of(const std::vector<std::vector<double>>& components) {
  std::vector<double> length(components.empty() ? 0 : components.front().size());
  for (const std::vector<double>& component : components)
    for (std::size_t i = 0; i < length.size(); ++i) length[i] = std::hypot(length[i], component[i]);
  return length;
}

namespace {

Pulse processed(const Pulse& pulse, std::optional<double> interval,
                const std::optional<PulseFilter>& filter) {
  const Pulse even = interval ? resampled(pulse, *interval) : pulse;
  return filter ? cfc_filtered(even, filter->channel_frequency_class, filter->corner, filter->ends) : even;
}

}  // namespace

ProcessedPulse processed_pulse(const MeasuredPulse& measured, std::optional<double> interval,
                               const std::optional<PulseFilter>& filter) {
  if (measured.components.empty()) return {processed(measured.pulse, interval, filter), {}};
  Pulse result;
  std::vector<std::vector<double>> components;
  for (const std::vector<double>& component : measured.components) {
    Pulse direction = processed({measured.pulse.time, component}, interval, filter);
    result.time = std::move(direction.time);
    components.push_back(std::move(direction.acceleration));
  }
  result.acceleration = resultant_of(components);
  const auto top = std::ranges::max_element(result.acceleration) - result.acceleration.begin();
  std::vector<double> along(result.time.size());
  for (const std::vector<double>& component : components) {
    const auto at = static_cast<std::size_t>(top);
    const double share = result.acceleration[at] > 0 ? component[at] / result.acceleration[at] : 0;
    for (std::size_t i = 0; i < along.size(); ++i) along[i] += share * component[i];
  }
  Pulse axis{result.time, std::move(along)};
  return {std::move(result), std::move(axis)};
}

std::vector<std::string> filter_remarks(const MeasuredPulse& measured, std::optional<double> interval,
                                        const PulseFilter& filter) {
  std::vector<std::string> remarks;
  const double slower = std::max(interval_of(measured.pulse), interval.value_or(0));
  const int of_class = filter.channel_frequency_class;
  if (!samples_suffice(of_class, slower))
    remarks.push_back(fmt::format("the sampling rate is {} kHz, but CFC{} requires at least {} kHz",
                                  brief(1e-3 / slower), of_class, brief(1e-2 * of_class)));
  // ISO/TS 13499: the last of sixteen characters is the filter class.
  constexpr std::array<std::pair<char, int>, 4> classes{{{'A', 1000}, {'B', 600}, {'C', 180}, {'D', 60}}};
  for (const MeasuredColumn& channel : measured.acceleration)
    for (const auto& [letter, filtered] : classes)
      if (measured.format == "ISO-MME" && channel.name.size() == 16 && channel.name.back() == letter)
        remarks.push_back(
            fmt::format("the code {} states that CFC{} has already been applied (filter class {}); applying "
                        "CFC{} as well lowers the peak and HIC further",
                        channel.name, filtered, letter, of_class));
  return remarks;
}

std::optional<double> resampling_for_filter(MeasuredPulse& measured) {
  if (measured.pulse.time.size() < 2 || is_evenly_spaced(measured.pulse)) return std::nullopt;
  const double interval = interval_for_filter(measured.pulse);
  measured.remarks.push_back(
      fmt::format("a filter needs evenly spaced samples, so these were resampled at intervals of {} ms "
                  "by linear interpolation",
                  brief(1e3 * interval)));
  return interval;
}

}  // namespace dashpad::injury
