#include "dashpad/injury/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "injury/hic_search.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

using hic_search::Best;
using hic_search::Blocks;
using hic_search::Curve;

/// HIC, g^2.5 s, from the criterion of levels in m/s2 that were multiplied by `scale`.
double hic_from(double criterion, double scale) {
  const double levels = scale * standard_gravity;
  return criterion / (levels * levels * std::sqrt(levels));
}

/// Offers the windows of greatest length. With a good first value most pairs of blocks can be skipped.
void offer_all_longest(const Curve& curve, double longest, Best& best) {
  const std::size_t intervals = curve.samples() - 1;
  std::size_t j = 0;
  for (std::size_t i = 0; i < intervals; ++i) {
    // The first interval in which a window from interval i can end.
    j = std::max(i, j);
    while (j < intervals && curve.elapsed(i, j + 1) < longest) ++j;
    for (std::size_t k = j; k < intervals && (k <= i || curve.elapsed(i + 1, k) <= longest); ++k)
      offer_longest(curve, i, k, longest, best);
  }
}

/// Branch and bound over pairs of blocks: windows that begin in one block and end in the other.
class Search {
 public:
  Search(const Curve& curve, double longest, Best& best)
      : curve_(curve), blocks_(curve), longest_(longest), best_(best) {}

  void run() { visit(blocks_.top(), 0, 0); }

 private:
  struct Pair {
    double bound = 0;
    std::size_t i = 0, j = 0;
  };

  void visit(std::size_t rank, std::size_t i, std::size_t j) {
    // Any window of the pair: a good value early on lets more pairs be skipped.
    const hic_search::Window window{blocks_.last(rank, i),
                                    std::max(blocks_.last(rank, i), Blocks::first(rank, j)), 0, 0};
    if (curve_.duration(window) <= longest_) best_.offer(curve_, window);
    if (rank == 0) {
      offer_candidates(curve_, i, j, longest_, best_);
      return;
    }
    --rank;
    std::array<Pair, 4> pairs;
    auto next = pairs.begin();
    const std::size_t count = blocks_.count(rank);
    for (std::size_t k = 2 * i; k < std::min(2 * i + 2, count); ++k)
      for (std::size_t l = std::max(k, 2 * j); l < std::min(2 * j + 2, count); ++l)
        *next++ = {blocks_.bound(rank, k, l, longest_), k, l};
    // Most promising pairs first.
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.bound > b.bound; });
    for (const Pair& pair : pairs)
      if (pair.bound > 0 && !best_.rules_out(pair.bound, curve_.time(Blocks::first(rank, pair.i))))
        visit(rank, pair.i, pair.j);
  }

  const Curve& curve_;
  const Blocks blocks_;
  const double longest_;
  Best& best_;
};

/// A band between two neighbouring sample values: the pulse is above `base` from `before` seconds ahead of
/// sample `first` to `after` seconds past sample `last`.
struct Band {
  std::size_t first = 0, last = 0;
  double base = 0;
  double before = 0, after = 0;
  double spread = 0;  ///< by how much both ends move as the level falls by 1, s
};

/// Visits the bands from the peak downwards, until `visit` returns false or the pulse ends on both sides.
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

/// Offers all windows that end in a band on either side and can be the best.
void offer_band(const Curve& curve, const Band& band, double longest, Best& best) {
  const std::size_t begin = band.first > 0 ? band.first - 1 : 0;
  const std::size_t end = std::min(band.last, curve.samples() - 2);
  hic_search::offer_candidates(curve, begin, end, longest, best);
}

constexpr std::size_t long_record = 100'000;  // samples

/// The largest value of a window about the peak in which the pulse is above half of it, without the factor of
/// g.
double value_about_peak(const Pulse& pulse, std::size_t peak, double longest) {
  const double sign = pulse.acceleration[peak] < 0 ? -1 : 1, half = std::abs(pulse.acceleration[peak]) / 2;
  const auto level = [&](std::size_t i) { return sign * pulse.acceleration[i]; };
  std::size_t first = peak, last = peak;
  const auto fits = [&](std::size_t i, std::size_t j) { return pulse.time[j] - pulse.time[i] <= longest; };
  while (first > 0 && level(first - 1) >= half && fits(first - 1, last)) --first;
  while (last + 1 < pulse.time.size() && level(last + 1) >= half && fits(first, last + 1)) ++last;
  double gain = 0;
  for (std::size_t i = first; i < last; ++i)
    gain += (pulse.time[i + 1] - pulse.time[i]) * (level(i) + level(i + 1)) / 2;
  return hic_search::criterion(pulse.time[last] - pulse.time[first], gain);
}

/// The part of a long record that holds the best window; absent if that is most of it. A window no longer
/// than L of value v has a mean of at least m = (v / L)^(2/5), so it holds a sample of at least m, and lies
/// within L of it. The best window of any length ends where the pulse is at least 0.6 m.
std::optional<Pulse> part_of_best_window(const Pulse& pulse, std::size_t peak, double longest_window) {
  const std::vector<double>& time = pulse.time;
  if (time.size() < long_record) return std::nullopt;
  const double length = time.back() - time.front(), longest = std::min(longest_window, length);
  const double value = value_about_peak(pulse, peak, longest);
  if (!(value > 0 && std::isfinite(value))) return std::nullopt;
  constexpr double less = 0.999;  // far more than rounding
  const bool is_limited = longest < length;
  const double level = (is_limited ? 1 : 0.6) * less * portable::pow(value / longest, 0.4);
  const auto counts = [&](double acceleration) { return std::abs(acceleration) >= level; };
  const std::vector<double>& all = pulse.acceleration;
  const auto first = std::ranges::find_if(all, counts) - all.begin();
  const auto behind = std::find_if(all.rbegin(), all.rend(), counts).base() - all.begin();
  const double around = is_limited ? longest : 0;
  const auto begin = std::max<std::ptrdiff_t>(
      std::ranges::lower_bound(time, time[static_cast<std::size_t>(first)] - around) - time.begin() - 2, 0);
  const auto end = std::min<std::ptrdiff_t>(
      std::ranges::upper_bound(time, time[static_cast<std::size_t>(behind - 1)] + around) - time.begin() + 2,
      std::ssize(time));
  if (end - begin > std::ssize(time) / 2) return std::nullopt;
  return Pulse{{time.begin() + begin, time.begin() + end}, {all.begin() + begin, all.begin() + end}};
}

}  // namespace

Hic hic(const Pulse& pulse, double longest_window) {
  check(pulse);
  if (!(longest_window > 0)) throw std::invalid_argument("HIC: the longest window must be positive");
  const auto [lowest, highest] = std::minmax_element(pulse.acceleration.begin(), pulse.acceleration.end());
  const double largest = std::max(*highest, -*lowest);
  // For denormal numbers the power 2.5 is zero.
  if (largest < std::numeric_limits<double>::min()) return {0, pulse.time.front(), pulse.time.front()};
  const auto peak = (*highest >= -*lowest ? highest : lowest) - pulse.acceleration.begin();
  if (const auto part = part_of_best_window(pulse, static_cast<std::size_t>(peak), longest_window))
    return hic(*part, longest_window);
  const double scale = scale_for(largest);
  if (const std::optional<Hump> hump = hump_of(pulse))
    return hic_of(*hump, Curve(pulse, hump->sign * scale), scale, longest_window);
  Best best;
  for (const double sign : {1.0, -1.0}) {
    if (!(std::max(sign * *highest, sign * *lowest) > 0)) continue;
    const Curve curve(pulse, sign * scale);
    if (longest_window < unlimited_window) offer_all_longest(curve, longest_window, best);
    Search(curve, longest_window, best).run();
  }
  return {hic_from(best.value(), scale), best.begin(), best.end()};
}

double hic_d(double hic36) { return 0.75446 * hic36 + 166.4; }

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

/// As the level falls, the criterion grows while lead = level * duration - 0.6 gain is positive. Within a
/// band the lead is concave in the level; its derivative at the base is duration - 0.4 spread level, and
/// decreases by 1.4 spread per unit of level. A maximum is where the lead passes from positive to negative,
/// or rises and falls within a band. The gain of the whole pulse, the largest, ends the walk.
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

}  // namespace dashpad::injury
