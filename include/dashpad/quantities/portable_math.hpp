#pragma once
/// Elementary functions that give the same bits on every x86 processor, system and browser.
///
/// Those of a C library do not: each library, and glibc for each kind of processor, rounds the last digit its
/// own way. Where a step of the solver is nearly too long, that digit decides whether it is divided.

namespace dashpad::portable {

/// The exponential e^x, to 1.01 units in the last place for |x| <= 700, to 4 beyond; 0 below -745, infinite
/// above 709.8.
[[nodiscard]] double exp(double x);
/// The difference e^x - 1, to 4 units in the last place.
[[nodiscard]] double expm1(double x);
/// Natural logarithm, to 1 unit in the last place; minus infinity at 0, NaN below.
[[nodiscard]] double log(double x);
/// The logarithm ln(1 + x), to 3 units in the last place; minus infinity at -1, NaN below.
[[nodiscard]] double log1p(double x);
/// The power base^exponent of a base >= 0 as e^(exponent ln base): to 2 + 2 |exponent ln base| units in the
/// last place.
[[nodiscard]] double pow(double base, double exponent);
/// Sine, cosine and tangent of x, rad, |x| <= 39000; to 3, 3 and 6 units in the last place.
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
[[nodiscard]] double tan(double x);
/// Arc sine, rad, of -1 to 1; to 3 units in the last place.
[[nodiscard]] double asin(double x);
/// The product exp(x^2) erfc(x) for 0 <= x <= 25, to 1e-14.
[[nodiscard]] double scaled_erfc(double x);

}  // namespace dashpad::portable
