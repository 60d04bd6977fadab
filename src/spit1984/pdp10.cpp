#include "dashpad/spit1984/pdp10.hpp"

#include <cfloat>
#include <cmath>
#include <limits>

namespace dashpad::spit1984 {

static_assert(FLT_EVAL_METHOD == 0 && DBL_MANT_DIG == 53, "double must be computed in double precision");
static_assert(LDBL_MANT_DIG >= 64, "long double must tell whether a result lies above or below a half");

Pdp10 Pdp10::rounded_half(double x, long double exact) {
  const bool falls_short = std::fabs(exact) < std::fabs(x);
  return rounded(std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - (falls_short ? 1 : 0)));
}

/// The functions of double are accurate to one or two units of the last of 53 bits, so they decide unless
/// they come within 16 units of a half. Only then are those of 64 bits used, ten times slower.
template <class Function, class... Numbers>
Pdp10 Pdp10::rounded_function(Function f, Numbers... x) {
  constexpr std::uint64_t doubt = 16;
  const double value = f(x.value_...);
  const std::uint64_t rest = std::bit_cast<std::uint64_t>(value) & tail;
  if (rest < half - doubt || rest > half + doubt) return rounded(value);
  const long double better = f(exact(x)...);
  const auto nearest = static_cast<double>(better);
  return is_half(nearest) ? rounded_half(nearest, better) : rounded(nearest);
}

/// Truncating the double is right, because its rounding never lands on a number of 27 bits from below: unless
/// it is one, A/B differs from each such number by at least 1/(2^26 B) if it is in [1, 2), and by 1/(2^27 B)
/// if in [1/2, 1). With B < 2^27 that is more than half a unit of the last of 53 bits.
Pdp10 Pdp10::truncated_quotient(Pdp10 a, Pdp10 b) {
  return of_bits(std::bit_cast<std::uint64_t>(a.value_ / b.value_) & ~tail);
}

Pdp10 square_root(Pdp10 x) {
  if (x == 0) return {};
  int twos = 0;
  double fraction = std::frexp(std::fabs(x.value_), &twos);
  if (twos % 2 != 0) {
    fraction /= 2;
    ++twos;
  }
  const auto f = Pdp10::of_exact(fraction);  // in [1/4, 1)
  // Published runs admit 0.42050 to 0.42113 for the second intercept; 431/1024 is the only number there that,
  // like both slopes, fits an instruction's nine bits. With 0.42041016, 74 of 132 of Appendix C come out.
  const Pdp10 slope = fraction < 0.5 ? 0.828125 : 0.5859375;
  const Pdp10 intercept = fraction < 0.5 ? 0.29730225 : 0.4208984375;
  Pdp10 root = slope * f + intercept;
  for (int step = 0; step < 2; ++step) root = (root + Pdp10::truncated_quotient(f, root)) * 0.5;
  return Pdp10::of_exact(std::ldexp(root.value_, twos / 2));
}

Pdp10 exponential(Pdp10 x) {
  return Pdp10::rounded_function([](auto y) { return std::exp(y); }, x);
}

Pdp10 logarithm(Pdp10 x) {
  return Pdp10::rounded_function([](auto y) { return std::log(y); }, abs(x));
}

Pdp10 power(Pdp10 base, Pdp10 exponent) {
  return Pdp10::rounded_function([](auto y, auto z) { return std::pow(y, z); }, abs(base), exponent);
}

int truncated(Pdp10 x) {
  using Limits = std::numeric_limits<int>;
  if (x >= 0x1p31) return Limits::max();
  if (x <= -0x1p31) return Limits::min();
  return static_cast<int>(to_double(x));
}

std::uint64_t word(Pdp10 x) {
  if (x == 0) return 0;
  int twos = 0;
  const double fraction = std::frexp(to_double(abs(x)), &twos);
  const auto magnitude =
      (static_cast<std::uint64_t>(twos + 128) << 27) | static_cast<std::uint64_t>(fraction * 0x1p27);
  return x < 0 ? (1ULL << 36) - magnitude : magnitude;
}

}  // namespace dashpad::spit1984
