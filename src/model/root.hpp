#pragma once
/// Roots of increasing functions, which may be as steep as a jump in places: secants inside the bracket, and
/// TOMS 748 if they do not settle soon. For times of events within a step see impact/event_search.hpp.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {

/// Limits of the searches. None of them affects the root found, except those of the last secant.
struct RootNumerics {
  std::uintmax_t max_calls = 200;  ///< function calls by TOMS 748
  int max_secants_by_value = 10;   ///< secants of find_root()
  int max_secants = 12;            ///< secants of increasing_root()
  int max_strides = 200;           ///< evaluations while the sign on one side is not known
  double probe = 1e4;              ///< least step over the precision until the slope is known
  /// Longest chord over the precision whose slope is usable at the root, and largest step times chord over
  /// the precision squared, to which the error after a last step is proportional.
  double longest_chord = 1e8;
  double max_left = 1e10;
  int usual_bits = 50;  ///< precision of root_between(), bits
};
inline constexpr RootNumerics root_numerics;

/// The bracket of a root, f(low) <= 0 <= f(high), as far as the values are known.
struct RootBracket {
  double low = 0;
  double high = 0;
  double f_low = 0;
  double f_high = 0;
  bool low_known = false;
  bool high_known = false;

  [[nodiscard]] double middle() const { return low + (high - low) / 2; }
  void note(double x, double value) {
    if (value > 0)
      high = x, f_high = value, high_known = true;
    else
      low = x, f_low = value, low_known = true;
  }
  /// The place to evaluate next: `next`, inside the bracket and within a stride where no sign is known.
  [[nodiscard]] double place_inside(double next, double x, double& stride) const {
    if (next >= x && !high_known) {
      next = std::min({next, x + stride, high});
      stride *= 4;
    } else if (next <= x && !low_known) {
      next = std::max({next, x - stride, low});
      stride *= 4;
    } else if (!(next > low && next < high)) {
      next = middle();
    }
    return next;
  }
};

/// Narrows a bracket whose ends have values of different signs, or 0, until is_narrow(low, high).
template <class F, class Narrow>
void narrow(RootBracket& bracket, F&& f, Narrow&& is_narrow) {
  std::uintmax_t most = root_numerics.max_calls;
  std::tie(bracket.low, bracket.high) = boost::math::tools::toms748_solve(
      f, bracket.low, bracket.high, bracket.f_low, bracket.f_high, is_narrow, most);
}

/// The bracket narrowed to a number of bits; its values must be known.
template <class F>
RootBracket narrowed(RootBracket bracket, F&& f, int bits = root_numerics.usual_bits) {
  narrow(bracket, f, boost::math::tools::eps_tolerance<double>(static_cast<unsigned>(bits)));
  return bracket;
}

/// The root of a function that is negative at `low` and not at `high`, or the other way round.
template <class F>
double root_between(F&& f, double low, double high) {
  const double f_high = f(high);
  if (f_high == 0) return high;
  return narrowed({.low = low, .high = high, .f_low = f(low), .f_high = f_high}, f).middle();
}

// ------------------------------------------------------------------ by the value that counts as zero

struct RootSearch {
  double low = 0;                 ///< lower bound of the root; may be minus infinity
  double high = 0;                ///< upper bound of the root
  bool high_is_positive = false;  ///< whether f(high) >= 0 is known
  double guess = 0;
  double slope = 1;       ///< estimate of df/dx at the guess, > 0
  double resolution = 0;  ///< rounding of x
  double stride = 0;      ///< first stride in the search of a finite lower end
};

enum class RootPlace { inside, at_or_below_low, at_or_above_high };

struct Root {
  double x = 0;
  RootPlace place = RootPlace::inside;
};

/// Root of f, increasing on [low, high] (else some root is found). `near(value)` returns whether f = value is
/// close enough to zero; only secants ask it. The last call of f is at the returned x.
template <class F, class Near>
Root find_root(F&& f, Near&& near, RootSearch s) {
  RootBracket bracket{.low = s.low, .high = s.high};
  double slope = s.slope;
  double before = 0;
  double f_before = 0;
  double x = std::clamp(s.guess, s.low, s.high);
  double value = f(x);
  for (int i = 0; i < root_numerics.max_secants_by_value; ++i) {
    if (i > 0 && x != before) slope = (value - f_before) / (x - before);
    if (near(value)) return {x};
    bracket.note(x, value);
    before = x, f_before = value;
    double next = slope > 0 ? x - value / slope : (value > 0 ? bracket.low : bracket.high);
    if (!std::isfinite(bracket.low) && !(next < bracket.high && next > bracket.high - 4 * s.stride)) {
      next = bracket.high - s.stride;
      s.stride *= 2;
    }
    if (next >= bracket.high) {
      if (!bracket.high_known && !s.high_is_positive) {
        // The end itself may be the answer: f is evaluated there once.
        next = bracket.high;
      } else {
        next = std::isfinite(bracket.low) ? bracket.middle() : bracket.high - s.stride;
      }
    } else if (next <= bracket.low) {
      next = !bracket.low_known ? bracket.low : bracket.middle();
    }
    if (bracket.high - bracket.low <= s.resolution) break;
    const bool at_high = next == bracket.high;
    const bool at_low = next == bracket.low;
    x = next;
    value = f(x);
    if (at_high && value <= 0) return {x, RootPlace::at_or_above_high};
    if (at_low && value >= 0) return {x, RootPlace::at_or_below_low};
  }
  if (near(value)) return {x};
  // Not settled: complete the bracket, then narrow it.
  while (!bracket.low_known && !std::isfinite(bracket.low)) {
    const double trial = bracket.high - s.stride;
    s.stride *= 2;
    bracket.note(trial, f(trial));
  }
  if (!bracket.low_known) {
    bracket.f_low = f(bracket.low);
    if (bracket.f_low >= 0) return {bracket.low, RootPlace::at_or_below_low};
  }
  if (!bracket.high_known) {
    bracket.f_high = f(bracket.high);
    if (bracket.f_high <= 0)
      return {bracket.high, s.high_is_positive ? RootPlace::inside : RootPlace::at_or_above_high};
  }
  if (bracket.f_low < 0 && bracket.f_high > 0)
    narrow(bracket, f, [&s](double a, double b) { return std::abs(b - a) <= s.resolution; });
  x = bracket.middle();
  f(x);
  return {x};
}

// ------------------------------------------------------------------ by the precision of the root

struct IncreasingRootSearch {
  double guess = 0;
  double slope = 0;      ///< slope of the function at the guess; 0: not known
  double low = 0;        ///< lower bound of the root, returned if the function is positive there
  double high = 0;       ///< upper bound of the root, returned if the function is negative there
  double stride = 0;     ///< first limit of steps towards a side where no sign is known
  double precision = 0;  ///< precision of the root
};

struct IncreasingRoot {
  double x = 0;
  double slope = 0;  ///< slope of the function there, by the last chord; 0: at a bound
};

/// Whether a last step by the slope of a chord leads to within `precision` of the root.
inline bool is_close_to_root(double step, double chord, double precision) {
  return chord <= root_numerics.longest_chord * precision &&
         (std::abs(step) <= precision ||
          std::abs(step) * chord <= root_numerics.max_left * precision * precision);
}

template <class F>
IncreasingRoot increasing_root(F&& f, const IncreasingRootSearch& s) {
  RootBracket bracket{.low = s.low, .high = s.high};
  double stride = s.stride;
  double slope = s.slope;
  double x = std::clamp(s.guess, s.low, s.high);
  double before = 0;
  double f_before = 0;
  double chord = infinite;
  const auto is_narrow = [&](double a, double b) { return std::abs(b - a) <= s.precision; };
  const auto goes_on = [&](int i) {
    return i < root_numerics.max_secants ||
           (i < root_numerics.max_strides && !(bracket.low_known && bracket.high_known));
  };
  for (int i = 0; goes_on(i); ++i) {
    const double value = f(x);
    if (!std::isfinite(value)) return {x, 0};
    // Where the function is level, a slope from elsewhere is of no use.
    if (i > 0 && std::abs(x - before) > s.precision) {
      slope = std::max((value - f_before) / (x - before), 0.0);
      chord = std::abs(x - before);
    }
    if (value == 0) return {x, slope};
    bracket.note(x, value);
    if (x == s.low && value > 0) return {x, 0};
    if (x == s.high && value < 0) return {x, 0};
    double step = slope > 0 ? -value / slope : std::copysign(stride, -value);
    if (slope > 0 && is_close_to_root(step, chord, s.precision))
      return {std::clamp(x + step, bracket.low, bracket.high), slope};
    // A step too short to determine the slope would be repeated forever.
    if (std::abs(step) < root_numerics.probe * s.precision && !is_close_to_root(0, chord, s.precision))
      step = std::copysign(root_numerics.probe * s.precision, step);
    if (bracket.low_known && bracket.high_known && is_narrow(bracket.low, bracket.high)) break;
    before = x, f_before = value;
    x = bracket.place_inside(x + step, x, stride);
  }
  if (bracket.low_known && bracket.high_known && !is_narrow(bracket.low, bracket.high))
    narrow(
        bracket,
        [&](double at) {
          const double value = f(at);
          if (std::abs(at - before) > s.precision) slope = std::max((value - f_before) / (at - before), 0.0);
          before = at, f_before = value;
          return value;
        },
        is_narrow);
  return {bracket.middle(), slope};
}

}  // namespace dashpad
