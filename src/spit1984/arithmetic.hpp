#pragma once
/// What the 1984 program asks of a number besides + - * / and comparison: ABS, SQRT, EXP, ALOG, ** and INT.
/// The same names for IEEE numbers and for Pdp10, so that the program is one template over its arithmetic.
///
/// The functions of IEEE numbers are computed in the next wider format and rounded: the mathematical
/// library's own versions differ in the last bit between processors, with and without fused operations.
///
/// The run-time system of the original took the magnitude where SQRT or a base of ** was negative, with a
/// message; so do these, and no NaN begins there.

#include <cmath>
#include <concepts>
#include <type_traits>

#include "dashpad/spit1984/pdp10.hpp"

namespace dashpad::spit1984 {

template <std::floating_point Real>
using Wider = std::conditional_t<std::same_as<Real, float>, double, long double>;

template <std::floating_point Real>
double to_double(Real value) {
  return value;
}

template <std::floating_point Real>
Real abs(Real value) {
  return std::fabs(value);
}

template <std::floating_point Real>
Real square_root(Real value) {
  return std::sqrt(std::fabs(value));
}

template <std::floating_point Real>
Real exponential(Real value) {
  return static_cast<Real>(std::exp(static_cast<Wider<Real>>(value)));
}

template <std::floating_point Real>
Real logarithm(Real value) {
  return static_cast<Real>(std::log(static_cast<Wider<Real>>(std::fabs(value))));
}

template <std::floating_point Real>
Real power(Real base, Real exponent) {
  return static_cast<Real>(
      std::pow(static_cast<Wider<Real>>(std::fabs(base)), static_cast<Wider<Real>>(exponent)));
}

/// INT; beyond the range of int, its ends, and 0 for what is not a number.
template <std::floating_point Real>
int truncated(Real value) {
  if (std::isnan(value)) return 0;
  constexpr auto most = static_cast<Real>(1 << 30);
  return static_cast<int>(value < -most ? -most : value > most ? most : value);
}

}  // namespace dashpad::spit1984
