#include "injury/hump.hpp"

#include <algorithm>
#include <cmath>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/constants.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

using hic_search::Best;
using hic_search::Curve;

/// Between two neighbouring values of the samples: where the pulse is above `base` begins `before` seconds
/// ahead of sample `first` and ends `after` seconds past sample `last`.
struct Band {
  std::size_t first = 0, last = 0;
  double base = 0;
  double before = 0, after = 0;
  double spread = 0;  ///< by how much both ends move as the level falls by 1, s
};

/// Bands from the peak down, until `visit` returns false or the pulse ends on both sides.
template <class Time, class Level, class Visit>
void walk_down(std::size_t peak, std::size_t samples, Time time, Level level, Visit visit) {
  const double none = -infinite;
  Band band{.first = peak, .last = peak};
  while (band.first > 0 || band.last + 1 < samples) {
    const double left = band.first > 0 ? level(band.first - 1) : none;
    const double right = band.last + 1 < samples ? level(band.last + 1) : none;
    band.base = std::max(left, right);
    band.before = band.after = band.spread = 0;
    if (left > none) {
      const double slowness = (time(band.first) - time(band.first - 1)) / (level(band.first) - left);
      band.before = (level(band.first) - band.base) * slowness;
      band.spread += slowness;
    }
    if (right > none) {
      const double slowness = (time(band.last + 1) - time(band.last)) / (level(band.last) - right);
      band.after = (level(band.last) - band.base) * slowness;
      band.spread += slowness;
    }
    if (!visit(band)) return;
    if (left == band.base) --band.first;
    if (right == band.base) ++band.last;
  }
}

/// All windows that end in a band on either side and can be the best.
void offer_band(const Curve& curve, const Band& band, double longest, Best& best) {
  const std::size_t begin = band.first > 0 ? band.first - 1 : 0;
  const std::size_t end = std::min(band.last, curve.samples() - 2);
  hic_search::offer_candidates(curve, begin, end, longest, best);
}

}  // namespace

std::optional<Hump> hump_of(const Pulse& pulse) {
  const std::vector<double>& a = pulse.acceleration;
  const double sign = a[a.size() / 2] < 0 ? -1 : 1;
  if (!(sign * a.front() >= 0) || !(sign * a.back() >= 0)) return std::nullopt;
  std::size_t i = 1;
  while (i < a.size() && sign * a[i] > sign * a[i - 1]) ++i;
  const std::size_t peak = i - 1;
  while (i < a.size() && sign * a[i] < sign * a[i - 1]) ++i;
  if (i < a.size()) return std::nullopt;
  return Hump{peak, sign};
}

/// As the level falls the criterion grows while lead = level * duration - 0.6 gain is positive. Within a band
/// the lead is concave in the level, with the derivative duration - 0.4 spread level at the base less 1.4
/// spread a unit of level: a maximum is where it passes from positive to negative, or rises and falls within.
/// A window of duration T has at most the gain of the whole pulse, which ends the walk.
Hic hic_of(const Hump& hump, const Curve& curve, double scale, double longest_window) {
  Best best;
  const double whole = curve.gained(0, curve.samples() - 1);
  double top = curve.level(hump.peak), narrowest = 0;  // of the band: its level and duration there
  bool led = true;
  const auto visit = [&](const Band& band) {
    const double duration = band.before + curve.elapsed(band.first, band.last) + band.after;
    const double gain = curve.gained(band.first, band.last) +
                        band.before * (curve.level(band.first) + band.base) / 2 +
                        band.after * (curve.level(band.last) + band.base) / 2;
    const bool leads = band.base * duration > 0.6 * gain;
    const bool bends =
        duration - 0.4 * band.spread * band.base < 1.4 * band.spread * (top - band.base) * (1 + 1e-9);
    if (!led && !leads &&
        hic_search::criterion(narrowest, whole) < best.value() * (1 - 2 * hic_search::rounding))
      return false;
    if (duration >= longest_window || (!leads && (led || bends)))
      offer_band(curve, band, longest_window, best);
    led = leads;
    top = band.base;
    narrowest = duration;
    return duration < longest_window;
  };
  walk_down(
      hump.peak, curve.samples(), [&](std::size_t i) { return curve.time(i); },
      [&](std::size_t i) { return curve.level(i); }, visit);
  if (curve.elapsed(0, curve.samples() - 1) <= longest_window)
    best.offer(curve, {0, curve.samples() - 1, 0, 0});
  return {hic_from(best.value(), scale), best.begin(), best.end()};
}

Clip clip_of(const Hump& hump, const Pulse& pulse, double duration) {
  if (attainable(pulse, duration) > pulse.time.back() - pulse.time.front()) return {};
  const auto level = [&](std::size_t i) { return hump.sign * pulse.acceleration[i]; };
  Clip clip{level(hump.peak), pulse.time.front(), 0};
  double narrowest = 0;  // the duration at the top of the band, where the level is clip.level
  const auto visit = [&](const Band& band) {
    const double widest = band.before + (pulse.time[band.last] - pulse.time[band.first]) + band.after;
    if (widest < duration) {
      clip.level = band.base;
      narrowest = widest;
      return true;
    }
    clip.level = std::max(clip.level - (duration - narrowest) / band.spread, band.base);
    if (band.first > 0)
      clip.begin = pulse.time[band.first] - (level(band.first) - clip.level) *
                                                (pulse.time[band.first] - pulse.time[band.first - 1]) /
                                                (level(band.first) - level(band.first - 1));
    return false;
  };
  walk_down(
      hump.peak, pulse.time.size(), [&](std::size_t i) { return pulse.time[i]; }, level, visit);
  clip.end = std::min(clip.begin + duration, pulse.time.back());
  return clip;
}

double scale_for(double largest) { return std::ldexp(1.0, -std::ilogb(largest)); }

double hic_from(double criterion, double scale) {
  const double levels = scale * standard_gravity;
  return criterion / (levels * levels * std::sqrt(levels));
}

}  // namespace dashpad::injury
