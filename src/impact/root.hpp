#pragma once
/// Root of an increasing function from a good guess: secant steps, kept inside a bracket, and TOMS 748 where
/// they do not settle soon.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace dashpad {

struct RootSearch {
  double low = 0;                 ///< the root is sought above; may be minus infinity
  double high = 0;                ///< and below
  bool high_is_positive = false;  ///< whether f(high) >= 0 is
  double guess = 0;
  double slope = 1;       ///< estimate of df/dx at the guess, > 0
  double resolution = 0;  ///< of x: rounding
  double stride = 0;      ///< first stride in search of a finite lower end
};

enum class RootPlace { inside, at_or_below_low, at_or_above_high };

struct Root {
  double x = 0;
  RootPlace place = RootPlace::inside;
};

/// The root inside [s.low, s.high], at whose ends f has these values, by TOMS 748. The last call of f is at
/// the returned x.
template <class F>
double bracketed_root(F&& f, const RootSearch& s, double f_low, double f_high) {
  double low = s.low;
  double high = s.high;
  if (f_low < 0 && f_high > 0) {
    std::uintmax_t most = 200;
    const auto close = [&s](double a, double b) { return std::abs(b - a) <= s.resolution; };
    std::tie(low, high) = boost::math::tools::toms748_solve(f, low, high, f_low, f_high, close, most);
  }
  const double x = low + (high - low) / 2;
  f(x);
  return x;
}

/// f increasing on [low, high] (where it is not, some root is found). `near(value)` says whether f = value is
/// near enough to zero; it is asked after every call of f but those of TOMS 748. The last call of f is at the
/// returned x.
template <class F, class Near>
Root find_root(F&& f, Near&& near, RootSearch s) {
  constexpr int most_secants = 10;
  Root root{std::clamp(s.guess, s.low, s.high), RootPlace::inside};
  double slope = s.slope;
  double f_low = 0;
  double f_high = 0;
  bool have_low = false;
  bool have_high = false;
  const auto note = [&](double x, double value) {
    if (value > 0)
      s.high = x, f_high = value, have_high = true;
    else
      s.low = x, f_low = value, have_low = true;
  };
  double before = 0;
  double f_before = 0;
  double x = root.x;
  double value = f(x);
  for (int i = 0; i < most_secants; ++i) {
    if (i > 0 && x != before) slope = (value - f_before) / (x - before);
    if (near(value)) return root.x = x, root;
    note(x, value);
    before = x, f_before = value;
    double next = slope > 0 ? x - value / slope : (value > 0 ? s.low : s.high);
    if (!std::isfinite(s.low) && !(next < s.high && next > s.high - 4 * s.stride)) {
      next = s.high - s.stride;
      s.stride *= 2;
    }
    if (next >= s.high) {
      if (!have_high && !s.high_is_positive) {
        // The end itself may be the answer: the function is asked there once.
        next = s.high;
      } else {
        next = std::isfinite(s.low) ? s.low + (s.high - s.low) / 2 : s.high - s.stride;
      }
    } else if (next <= s.low) {
      next = !have_low ? s.low : s.low + (s.high - s.low) / 2;
    }
    if (s.high - s.low <= s.resolution) break;
    const bool at_high = next == s.high;
    const bool at_low = next == s.low;
    x = next;
    value = f(x);
    if (at_high && value <= 0) return root.x = x, root.place = RootPlace::at_or_above_high, root;
    if (at_low && value >= 0) return root.x = x, root.place = RootPlace::at_or_below_low, root;
  }
  if (near(value)) return root.x = x, root;
  // Not settled: make the bracket sure, then close it.
  while (!have_low && !std::isfinite(s.low)) {
    const double trial = s.high - s.stride;
    s.stride *= 2;
    note(trial, f(trial));
  }
  if (!have_low) {
    f_low = f(s.low);
    if (f_low >= 0) return root.x = s.low, root.place = RootPlace::at_or_below_low, root;
  }
  if (!have_high) {
    f_high = f(s.high);
    if (f_high <= 0) {
      if (!s.high_is_positive) root.place = RootPlace::at_or_above_high;
      return root.x = s.high, root;
    }
  }
  root.x = bracketed_root(f, s, f_low, f_high);
  return root;
}

}  // namespace dashpad
