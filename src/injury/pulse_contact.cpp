#include <algorithm>
#include <cmath>
#include <cstddef>

#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

constexpr double of_the_width = 0.25;  // longest interruption
constexpr double goes_on = 1.01;       // of the velocity so far: the interruption was not the end
constexpr double max_scatter = 0.05;   // of the peak: the limit for a quiet part
constexpr double highest_level = 0.5;  // of the peak: an offset higher than that leaves no pulse
constexpr double rounding = 1e-6;      // of the peak

/// The level of the quiet part, with the sign of the peak; 0 without one.
double level_of(const Pulse& pulse, const std::optional<Stretch>& quiet, double side, double peak) {
  if (!quiet) return 0;
  const auto begin = std::ranges::lower_bound(pulse.time, quiet->begin) - pulse.time.begin();
  const auto end = std::ranges::upper_bound(pulse.time, quiet->end) - pulse.time.begin();
  if (end - begin < 2) return 0;
  const auto count = static_cast<double>(end - begin);
  double sum = 0, squares = 0;
  for (auto i = begin; i < end; ++i) sum += side * pulse.acceleration[static_cast<std::size_t>(i)];
  const double mean = sum / count;
  for (auto i = begin; i < end; ++i)
    squares += std::pow(side * pulse.acceleration[static_cast<std::size_t>(i)] - mean, 2);
  const double scatter = std::sqrt(squares / (count - 1)), level = mean + scatter + rounding * peak;
  return scatter < max_scatter * peak && level < highest_level * peak ? level : 0;
}

/// The time above half the peak, s, within the stretch around the peak above `level`. A second impact is
/// outside of it; dips that stay above `level` do not interrupt it.
double width_of_hump(const Pulse& pulse, std::size_t peak, double side, double level) {
  const auto is_inside = [&](std::size_t i) { return side * pulse.acceleration[i] > level; };
  std::size_t first = peak, last = peak;
  while (first > 0 && is_inside(first)) --first;
  while (last + 1 < pulse.time.size() && is_inside(last)) ++last;
  Pulse hump;
  for (std::size_t i = first; i <= last; ++i) {
    hump.time.push_back(pulse.time[i]);
    hump.acceleration.push_back(std::max(side * pulse.acceleration[i], 0.0));
  }
  return cumulative_dwell(hump, hump.acceleration[peak - first] / 2);
}

/// The last sample of the contact, from the peak forwards or backwards.
std::size_t last_of_contact(const Pulse& pulse, std::size_t peak, bool forwards, double side, double level,
                            double longest) {
  const std::vector<double>&time = pulse.time, &a = pulse.acceleration;
  double gained = 0, gained_at_end = 0;  // m/s, since the peak
  std::size_t end = peak;
  bool inside = true;
  for (std::size_t i = peak; forwards ? i + 1 < time.size() : i > 0;) {
    const std::size_t next = forwards ? i + 1 : i - 1;
    gained += side * (a[i] / 2 + a[next] / 2) * std::abs(time[next] - time[i]);
    i = next;
    if (!inside && std::abs(time[i] - time[end]) > longest) break;
    if (side * a[i] <= level)
      inside = false;
    else if (inside || gained > goes_on * gained_at_end)
      inside = true, end = i, gained_at_end = gained;
  }
  return end;
}

}  // namespace

Contact contact_of(const Pulse& along, const std::optional<Stretch>& quiet) {
  const Peak top = peak(along);
  if (top.magnitude == 0) return {along.time.front(), along.time.front(), 0};
  const std::vector<double>&time = along.time, &a = along.acceleration;
  const std::size_t at = peak_sample(along);
  const double side = a[at] < 0 ? -1 : 1;
  const double level = level_of(along, quiet, side, top.magnitude);
  const double longest = of_the_width * width_of_hump(along, at, side, level);
  const std::size_t first = last_of_contact(along, at, false, side, level, longest);
  const std::size_t last = last_of_contact(along, at, true, side, level, longest);
  Pulse contact;
  const auto add = [&contact](double when, double value) {
    if (!contact.time.empty() && when <= contact.time.back()) return;  // rounded onto a sample
    contact.time.push_back(when);
    contact.acceleration.push_back(value);
  };
  const auto passing = [&](std::size_t outside, std::size_t inside) {
    return std::lerp(time[outside], time[inside], (a[outside] - side * level) / (a[outside] - a[inside]));
  };
  if (first > 0) add(passing(first - 1, first), side * level);
  for (std::size_t i = first; i <= last; ++i) add(time[i], a[i]);
  if (last + 1 < a.size()) add(passing(last + 1, last), side * level);
  return {contact.time.front(), contact.time.back(), contact.time.size() < 2 ? 0 : velocity_change(contact)};
}

}  // namespace dashpad::injury
