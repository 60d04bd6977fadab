#include "dashpad/injury/cfc_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

using Samples = std::vector<double>;

constexpr double extension = 10e-3;             // s
constexpr std::size_t min_extension = 100;      // samples, of mirrored ends
constexpr std::size_t samples_of_mean = 10;     // of mirrored_from_mean
constexpr std::size_t outermost_extension = 9;  // samples, of negated_before: three filter lengths
constexpr double max_samples = 10e6;            // of resampled()
constexpr double evenness = 1e-3;               // of the interval

/// The first sample that is not in its place on an even grid; their number without any.
std::size_t first_out_of_place(const Pulse& pulse) {
  const double interval = interval_of(pulse);
  std::size_t i = 0;
  while (i < pulse.time.size() &&
         std::abs(pulse.time[i] - (pulse.time[0] + static_cast<double>(i) * interval)) <= evenness * interval)
    ++i;
  return i;
}

double even_interval(const Pulse& pulse) {
  const std::size_t uneven = first_out_of_place(pulse);
  if (uneven < pulse.time.size())
    throw std::invalid_argument("filter: the samples must be evenly spaced, but sample " +
                                std::to_string(uneven + 1) + " is out of place");
  return interval_of(pulse);
}

/// Prepends twice - x, in reverse and without the first sample.
void put_before(Samples& samples, std::size_t count, double twice) {
  count = std::min(count, samples.size() - 1);
  Samples front(count);
  for (std::size_t i = 0; i < count; ++i) front[i] = twice - samples[count - i];
  samples.insert(samples.begin(), front.begin(), front.end());
}

/// Appends 2 x(end) - x.
void mirror_behind(Samples& samples, std::size_t count) {
  const std::size_t size = samples.size();
  count = std::min(count, size - 1);
  for (std::size_t i = 0; i < count; ++i) samples.push_back(2 * samples[size - 1] - samples[size - 2 - i]);
}

void mirror(Samples& samples, std::size_t count) {
  const std::size_t own = std::min(count, samples.size() - 1);  // before the samples grow
  put_before(samples, own, 2 * samples.front());
  mirror_behind(samples, own);
}

/// Extends the samples; returns the number of samples prepended.
std::size_t extend(Samples& samples, double interval, Ends ends) {
  const std::size_t size = samples.size();
  const double spare = 1e-6;  // an interval of 0.1 ms fits into 10 ms a hundred times
  const double fitting = std::min(extension / interval + spare, static_cast<double>(size));
  const auto count = static_cast<std::size_t>(fitting);
  switch (ends) {
    case Ends::held: return 0;
    case Ends::mirrored:
    case Ends::mirrored_from_mean:
      mirror(samples, std::max(count, min_extension));
      return (samples.size() - size) / 2;
    case Ends::negated_before: {
      mirror_behind(samples, std::min(count + 1, size - 1));
      put_before(samples, std::min(count, size - 1), 0);
      const std::size_t inner = samples.size();
      mirror(samples, outermost_extension);
      return std::min(count, size - 1) + (samples.size() - inner) / 2;
    }
  }
  throw std::invalid_argument("filter: unknown treatment of the ends");
}

/// One run, in place. Since b1 = 1 - 4 a0 - b2, the recursion can be written with differences that vanish for
/// a constant, so that rounding does not change its gain even with a0 of 1e-7.
void run(Samples& samples, const FilterCoefficients& c, Ends ends) {
  double x1 = samples[0];
  double x2 = samples[0];
  double y1 = samples[0];
  double y2 = samples[0];
  std::size_t begin = 0;
  if (ends == Ends::mirrored_from_mean) {
    const std::size_t size = std::min(samples_of_mean, samples.size());
    const auto ten = samples.begin() + static_cast<std::ptrdiff_t>(size);
    y1 = y2 = std::accumulate(samples.begin(), ten, 0.0) / static_cast<double>(size);
    x1 = samples[1];
    samples[0] = samples[1] = y1;
    begin = 2;
  }
  for (std::size_t i = begin; i < samples.size(); ++i) {
    const double x = samples[i];
    const double y = y1 - c.b2 * (y1 - y2) + c.a0 * ((x - y1) + 2 * (x1 - y1) + (x2 - y1));
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    samples[i] = y;
  }
}

}  // namespace

FilterCoefficients cfc_coefficients(double channel_frequency_class, double interval, Corner corner) {
  if (!(channel_frequency_class > 0) || !std::isfinite(channel_frequency_class))
    throw std::invalid_argument("filter: the channel frequency class must be positive");
  if (!(interval > 0)) throw std::invalid_argument("filter: the sampling interval must be positive");
  const double ratio = corner == Corner::sae_j211 ? 2.0775 : 1.25 / 0.6;
  const double angle = std::numbers::pi * channel_frequency_class * ratio * interval;  // wd T / 2
  if (!(angle < std::numbers::pi / 2))
    throw std::invalid_argument("filter: the sampling interval is too long for the channel frequency class");
  const double wa = std::tan(angle);
  const double scale = 1 / (1 + std::numbers::sqrt2 * wa + wa * wa);
  const double a0 = wa * wa * scale;
  return {a0, 2 * a0, a0, -2 * (wa * wa - 1) * scale, (-1 + std::numbers::sqrt2 * wa - wa * wa) * scale};
}

const char* to_string(Corner corner) { return corner == Corner::sae_j211 ? "sae" : "iso"; }

const char* to_string(Ends ends) {
  constexpr const char* names[]{"mirrored", "held", "mirrored-from-mean", "negated-before"};
  return names[static_cast<std::size_t>(ends)];
}

bool samples_suffice(double channel_frequency_class, double interval) {
  const double margin = 1 + 1e-9;  // an interval from a time column is rounded
  return 10 * channel_frequency_class * interval <= margin;
}

bool is_evenly_spaced(const Pulse& pulse) { return first_out_of_place(pulse) == pulse.time.size(); }

double interval_for_filter(const Pulse& pulse) {
  std::vector<double> steps(pulse.time.size());
  std::adjacent_difference(pulse.time.begin(), pulse.time.end(), steps.begin());
  steps.erase(steps.begin());
  constexpr std::size_t shorter = 20, more_samples = 20;
  const auto place = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / shorter);
  std::nth_element(steps.begin(), place, steps.end());
  return std::max(*place, interval_of(pulse) / more_samples);
}

Pulse cfc_filtered(const Pulse& pulse, double channel_frequency_class, Corner corner, Ends ends) {
  check(pulse);
  const double interval = even_interval(pulse);
  const FilterCoefficients coefficients = cfc_coefficients(channel_frequency_class, interval, corner);
  Samples samples = pulse.acceleration;
  const auto before = static_cast<std::ptrdiff_t>(extend(samples, interval, ends));
  run(samples, coefficients, ends);
  std::reverse(samples.begin(), samples.end());
  run(samples, coefficients, ends);
  std::reverse(samples.begin(), samples.end());
  const auto begin = samples.begin() + before;
  return {pulse.time, {begin, begin + static_cast<std::ptrdiff_t>(pulse.time.size())}};
}

Pulse resampled(const Pulse& pulse, double interval) {
  check(pulse);
  const double length = pulse.time.back() - pulse.time.front();
  const double latest = std::max(std::abs(pulse.time.front()), std::abs(pulse.time.back()));
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * latest;  // of both times
  const double intervals = (length + rounding) / interval;
  if (!(interval > 0)) throw std::invalid_argument("resampling: the interval must be positive");
  if (!(intervals < max_samples)) throw std::invalid_argument("resampling: the limit is 10 million samples");
  const auto last = static_cast<std::size_t>(intervals);
  if (last == 0) throw std::invalid_argument("resampling: the interval is longer than the pulse");
  Pulse even;
  even.time.reserve(last + 1);
  even.acceleration.reserve(last + 1);
  std::size_t piece = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const double time = std::min(pulse.time.front() + static_cast<double>(i) * interval, pulse.time.back());
    while (piece + 2 < pulse.time.size() && pulse.time[piece + 1] <= time) ++piece;
    const double share = (time - pulse.time[piece]) / (pulse.time[piece + 1] - pulse.time[piece]);
    even.time.push_back(time);
    even.acceleration.push_back(std::lerp(pulse.acceleration[piece], pulse.acceleration[piece + 1], share));
  }
  check(even);
  return even;
}

}  // namespace dashpad::injury
