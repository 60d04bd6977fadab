#pragma once
/// Where an increasing function passes zero, from a good guess, between two bounds: secant steps inside the
/// bracket found so far, and TOMS 748 where they do not settle soon. The function may be as steep as a jump.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace dashpad {

struct IncreasingRootSearch {
  double guess = 0;
  double slope = 0;      ///< of the function at the guess, as far as it is known; 0: it is not
  double low = 0;        ///< the root is not below; where the function is positive there, that is the answer
  double high = 0;       ///< nor above; likewise
  double stride = 0;     ///< farthest step at first towards a side where no sign is known yet
  double precision = 0;  ///< of the root
};

struct IncreasingRoot {
  double x = 0;
  double slope = 0;  ///< of the function there, by the last chord; 0: at a bound
};

/// Whether a root lies no farther off than `precision` after a last step by the slope of a chord: what that
/// leaves is in proportion to both. Of a long chord the slope may be that of a steep place elsewhere.
inline bool is_close_to_root(double step, double chord, double precision) {
  constexpr double longest = 1e8;     // chord, in the precision
  constexpr double quadratic = 1e10;  // step times chord, in the precision squared
  return chord <= longest * precision &&
         (std::abs(step) <= precision || std::abs(step) * chord <= quadratic * precision * precision);
}

/// The bracket of a root: f(low) <= 0 <= f(high), as far as they are known.
struct RootBracket {
  double low = 0;
  double high = 0;
  double f_low = 0;
  double f_high = 0;
  bool low_known = false;
  bool high_known = false;

  void note(double x, double value) {
    if (value > 0)
      high = x, f_high = value, high_known = true;
    else
      low = x, f_low = value, low_known = true;
  }
  /// Where to look next instead of `next`, so that it lies inside and no farther than a stride where no sign
  /// is known.
  [[nodiscard]] double place_inside(double next, double x, double& stride) const {
    if (next >= x && !high_known) {
      next = std::min({next, x + stride, high});
      stride *= 4;
    } else if (next <= x && !low_known) {
      next = std::max({next, x - stride, low});
      stride *= 4;
    } else if (!(next > low && next < high)) {
      next = low + (high - low) / 2;
    }
    return next;
  }
};

template <class F>
IncreasingRoot increasing_root(F&& f, const IncreasingRootSearch& s) {
  constexpr int most_secants = 12;
  constexpr int most_strides = 200;
  constexpr double probe = 1e4;  // step in the precision, at least, until the slope is known
  RootBracket bracket{.low = s.low, .high = s.high};
  double stride = s.stride;
  double slope = s.slope;
  double x = std::clamp(s.guess, s.low, s.high);
  double before = 0;
  double f_before = 0;
  double chord = std::numeric_limits<double>::infinity();
  const auto is_narrow = [&](double a, double b) { return std::abs(b - a) <= s.precision; };
  for (int i = 0; i < most_secants || (i < most_strides && !(bracket.low_known && bracket.high_known)); ++i) {
    const double value = f(x);
    if (!std::isfinite(value)) return {x, 0};
    // Where it is level, a slope known from elsewhere says nothing.
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
    // A step too short to tell the slope would go on for ever.
    if (std::abs(step) < probe * s.precision && !is_close_to_root(0, chord, s.precision))
      step = std::copysign(probe * s.precision, step);
    if (bracket.low_known && bracket.high_known && is_narrow(bracket.low, bracket.high)) break;
    before = x, f_before = value;
    x = bracket.place_inside(x + step, x, stride);
  }
  if (bracket.low_known && bracket.high_known && !is_narrow(bracket.low, bracket.high)) {
    std::uintmax_t most = 200;
    std::tie(bracket.low, bracket.high) = boost::math::tools::toms748_solve(
        [&](double at) {
          const double value = f(at);
          if (std::abs(at - before) > s.precision) slope = std::max((value - f_before) / (at - before), 0.0);
          before = at, f_before = value;
          return value;
        },
        bracket.low, bracket.high, bracket.f_low, bracket.f_high, is_narrow, most);
  }
  return {bracket.low + (bracket.high - bracket.low) / 2, slope};
}

}  // namespace dashpad
