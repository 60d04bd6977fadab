#include "injury/short_spike.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "quantities/text.hpp"

namespace dashpad::injury {

namespace {

bool is_of_level(const ResultQuantity& quantity) { return quantity.role.doubt == Doubt::of_level; }

/// Whether a spike of any height leaves the figure as it is if it is short enough.
bool is_clip(const ResultQuantity& quantity) {
  const std::string_view key = quantity.key;  // a response of studies is a copy
  return is_of_level(quantity) || key == "clip_3ms" || key == "cumulative_3ms";
}

/// Whether the figure is one of the force and grows with a spike, however short: peaks, HIC, severity index.
bool sees_spikes(const ResultQuantity& quantity) {
  return quantity.role.growth == Growth::with_force && !is_clip(quantity);
}

/// What became of the pad: "the pad is crushed through"; empty if it stayed within the tests of its foam.
std::string state_of_pad(const Summary& summary) {
  if (summary.bottomed || (summary.layers.empty() && is_struck_through(summary.peak_strain, 1)))
    return "the pad is crushed through";
  for (std::size_t i = 0; i < summary.layers.size(); ++i)
    if (summary.layers[i].struck_through) return fmt::format("layer {} of the pad is crushed through", i + 1);
  const auto beyond = std::ranges::find(summary.extrapolations, Beyond::strain, &Extrapolation::beyond);
  if (beyond == summary.extrapolations.end()) return "";
  return summary.layers.empty()
             ? fmt::format("the pad is strained to {:.3g}, beyond the tests of its foam", summary.peak_strain)
             : "a layer of the pad is strained beyond the tests of its foam";
}

/// "a peak of 412 g": the peak clearly above the level, or the end of its interval; empty if neither is. The
/// peak of a smooth pulse is a little above its clip, which sees it well: by 12 % for a half sine of 10 ms.
std::string peak_above(double level, const Summary& summary) {
  constexpr double of_a_spike = 1.25;
  level *= of_a_spike;
  // A pad without thickness has no peak that means anything.
  const double most = 1e4;
  const auto in_g = [most](double acceleration) {
    const double value = acceleration / standard_gravity;
    return value > most ? fmt::format("more than {}", most) : brief(rounded_to(value, 3));
  };
  const double peak = *summary.peak_acceleration;
  if (peak > level) return fmt::format("a peak of {} g", in_g(peak));
  const FigureInterval* const interval =
      summary.intervals ? summary.intervals->find("peak_acceleration") : nullptr;
  if (interval == nullptr || !(interval->high > level)) return "";
  return std::isfinite(interval->high)
             ? fmt::format("a peak of {} g, but possibly {} g,", in_g(peak), in_g(interval->high))
             : fmt::format("a peak of {} g, but possibly any height,", in_g(peak));
}

}  // namespace

std::optional<Flag> short_spike(const Summary& summary, std::span<const UpperLimit> limits) {
  if (!summary.peak_acceleration ||
      std::ranges::any_of(limits, [](const UpperLimit& limit) { return sees_spikes(*limit.quantity); }))
    return std::nullopt;
  const UpperLimit* lowest = nullptr;
  const auto level_of = [](const UpperLimit& limit) {
    return is_of_level(*limit.quantity) ? limit.level : limit.value;
  };
  for (const UpperLimit& limit : limits)
    if (is_clip(*limit.quantity) && (lowest == nullptr || level_of(limit) < level_of(*lowest)))
      lowest = &limit;
  const std::string state = state_of_pad(summary);
  if (lowest == nullptr || state.empty()) return std::nullopt;
  const std::string peak = peak_above(level_of(*lowest), summary);
  if (peak.empty()) return std::nullopt;
  return flag_of(
      short_spike_name,
      fmt::format(
          "{}, with {} too short for the {} to see", state, peak,
          is_of_level(*lowest->quantity) ? "limit on the dwell time" : title_in_sentence(*lowest->quantity)),
      {{"peak_acceleration_m_per_s2", *summary.peak_acceleration}, {"peak_strain", summary.peak_strain}});
}

std::string words_of(const Flag& flag) { return flag.text.substr(flag.name.size() + 2); }

}  // namespace dashpad::injury
