#pragma once
/// Integrals with their estimated errors, by the two rules of Boost.Math that the laboratory needs.

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

namespace dashpad::laboratory {

/// A number and how far it may be off.
struct WithError {
  double value = 0;
  double error = 0;  ///< estimated, >= 0
};

/// One application of the rule of 15 points; the error is the distance from the one of 7, far too large.
template <class F>
WithError bisected(F&& f, double from, double to, double relative, double absolute, int depth) {
  // Boost forgets the length of the interval in the error, so it gets one of length 2.
  const double middle = from + (to - from) / 2;
  const double half = (to - from) / 2;
  const auto scaled = [&](double z) { return half * f(middle + half * z); };
  WithError result;
  double magnitude = 0;
  result.value = boost::math::quadrature::gauss_kronrod<double, 15>::integrate(scaled, -1.0, 1.0, 0, 0,
                                                                               &result.error, &magnitude);
  if (absolute < 0) absolute = relative * magnitude;
  if (depth == 0 || !(result.error > absolute)) return result;
  const WithError first = bisected(f, from, middle, relative, absolute / 2, depth - 1);
  const WithError second = bisected(f, middle, to, relative, absolute / 2, depth - 1);
  return {first.value + second.value, first.error + second.error};
}

/// Of a smooth function, to a fraction of the integral of its magnitude. (The adaptive rule of Boost compares
/// with the integral itself, and does not end where that is nearly zero.)
template <class F>
WithError integral(F&& f, double from, double to, double tolerance = 1e-11, int depth = 15) {
  return to > from ? bisected(f, from, to, tolerance, -1, depth) : WithError{};
}

/// Of a function that may have an infinite slope or an integrable infinity where it begins. From 0 on is
/// best: there the distance from the beginning has no rounding.
template <class F>
WithError integral_from_singularity(F&& f, double from, double to, double tolerance = 1e-12) {
  thread_local boost::math::quadrature::tanh_sinh<double> rule(12);
  if (!(to > from)) return {};
  WithError result;
  result.value = rule.integrate(f, from, to, tolerance, &result.error);
  return result;
}

}  // namespace dashpad::laboratory
