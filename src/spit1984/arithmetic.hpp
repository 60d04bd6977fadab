#pragma once
/// The functions that the 1984 program needs besides + - * / and comparison: ABS, SQRT, EXP, ALOG, ** and
/// INT. IEEE numbers and Pdp10 have the same names, so that the program is one template over its arithmetic.
///
/// The functions of IEEE numbers are computed in the next wider format and rounded, because the mathematical
/// library differs in the last bit between processors.
///
/// Like the original system, SQRT and ** take the magnitude of a negative argument or base: no NaN arises.

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

/// INT, limited to about half the range of int; 0 for NaN.
template <std::floating_point Real>
int truncated(Real value) {
  if (std::isnan(value)) return 0;
  constexpr auto most = static_cast<Real>(1 << 30);
  return static_cast<int>(value < -most ? -most : value > most ? most : value);
}

}  // namespace dashpad::spit1984
