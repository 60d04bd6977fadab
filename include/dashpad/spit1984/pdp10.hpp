#pragma once
/// Single precision of the 36-bit PDP-10 (DECSystem-10), on which the 1984 program ran.
///
/// A number is a fraction of 27 bits in [1/2, 1) times a power of two from 2^-128 to 2^127. A sum,
/// difference, product or quotient is the exact one rounded to 27 bits, halves away from zero. Beyond the
/// largest number the result is that number with its sign, below the smallest it is 0: the run-time system
/// substituted these after a message. There is no infinity, no "not a number" and no negative zero.
///
/// These rules, and the square root, were found by reproducing the printout of Appendix C. Rules marked as
/// assumed never apply in that printout and were not checked.

#include <bit>
#include <compare>
#include <cstdint>
#include <stdexcept>

namespace dashpad::spit1984 {

/// A number of 27 bits, held as a double.
///
/// Computing in double and rounding again is right because rounding to double keeps order, and every number
/// half-way between two of 27 bits is itself a double. So the first rounding never carries a result across
/// such a half; it can only land on one. Only then must the second rounding know on which side the exact
/// result was, and the operation is repeated in long double, where the answer is certain:
/// - a product of 27-bit numbers has 54 bits: exact;
/// - a sum or difference that lands there has at most 56 bits, since the numbers are at most a factor of 2^29
/// apart: exact;
/// - a quotient is never a half, and differs from each by more than 2^-55 of itself: 64 bits tell.
class Pdp10 {
 public:
  constexpr Pdp10() = default;
  /// Rounds to 27 bits. A decimal constant is rounded twice, which matters only within 2^-53 of itself from a
  /// half. Infinity becomes the largest number.
  /// @throws std::invalid_argument for NaN.
  constexpr Pdp10(double value) : Pdp10(rounded(value)) {
    if (value != value) throw std::invalid_argument("the PDP-10 cannot represent NaN");
  }
  constexpr Pdp10(int value) : Pdp10(rounded(value)) {}

  friend constexpr double to_double(Pdp10 x) { return x.value_; }

  friend constexpr bool operator==(Pdp10, Pdp10) = default;
  // clang-tidy 14 takes the 0 that a defaulted comparison brings along for a pointer.
  friend constexpr auto operator<=>(Pdp10, Pdp10) = default;  // NOLINT(modernize-use-nullptr)

  friend constexpr Pdp10 operator-(Pdp10 x) { return of_exact(0 - x.value_); }  // 0 - 0 is not negative
  friend constexpr Pdp10 abs(Pdp10 x) { return x.value_ < 0 ? -x : x; }

  friend Pdp10 operator+(Pdp10 a, Pdp10 b) {
    const double sum = a.value_ + b.value_;
    return is_half(sum) ? rounded_half(sum, exact(a) + b.value_) : rounded(sum);
  }
  friend Pdp10 operator-(Pdp10 a, Pdp10 b) {
    const double difference = a.value_ - b.value_;
    return is_half(difference) ? rounded_half(difference, exact(a) - b.value_) : rounded(difference);
  }
  friend Pdp10 operator*(Pdp10 a, Pdp10 b) {
    const double product = a.value_ * b.value_;
    return is_half(product) ? rounded_half(product, exact(a) * b.value_) : rounded(product);
  }
  /// Division by zero gives the largest number with the sign of the dividend; 0/0 the positive one (assumed).
  friend Pdp10 operator/(Pdp10 a, Pdp10 b) {
    if (b.value_ == 0) return a.value_ < 0 ? -largest() : largest();
    const double quotient = a.value_ / b.value_;
    return is_half(quotient) ? rounded_half(quotient, exact(a) / b.value_) : rounded(quotient);
  }

  static constexpr Pdp10 largest() { return of_exact((1 - 0x1p-27) * 0x1p127); }
  static constexpr Pdp10 smallest() { return of_exact(0x1p-129); }  ///< above zero

  friend Pdp10 square_root(Pdp10 x);
  friend Pdp10 exponential(Pdp10 x);
  friend Pdp10 logarithm(Pdp10 x);
  friend Pdp10 power(Pdp10 base, Pdp10 exponent);

 private:
  static constexpr std::uint64_t sign = 1ULL << 63;
  static constexpr std::uint64_t tail = (1ULL << 26) - 1;  ///< bits of a double that do not fit
  static constexpr std::uint64_t half = 1ULL << 25;        ///< of the last bit that fits

  static constexpr Pdp10 of_exact(double value) {
    Pdp10 x;
    x.value_ = value;
    return x;
  }
  static constexpr Pdp10 of_bits(std::uint64_t bits) { return of_exact(std::bit_cast<double>(bits)); }
  static constexpr long double exact(Pdp10 x) { return x.value_; }

  static constexpr bool is_half(double x) { return (std::bit_cast<std::uint64_t>(x) & tail) == half; }

  /// Rounds halves away from zero. A carry out of the fraction goes into the adjacent exponent.
  static constexpr Pdp10 rounded(double x) {
    const std::uint64_t bits = (std::bit_cast<std::uint64_t>(x) + half) & ~tail;
    constexpr auto least = std::bit_cast<std::uint64_t>(0x1p-129);
    constexpr auto beyond = std::bit_cast<std::uint64_t>(0x1p127);
    const std::uint64_t magnitude = bits & ~sign;
    if (magnitude - least < beyond - least) [[likely]]
      return of_bits(bits);
    if (magnitude < least) return {};
    return bits == magnitude ? largest() : -largest();
  }
  /// Rounds `x`, which is a half and the double nearest to `exact`, to the side of `exact`.
  static Pdp10 rounded_half(double x, long double exact);
  /// f(x...) of the C library.
  template <class Function, class... Numbers>
  static Pdp10 rounded_function(Function f, Numbers... x);
  /// The quotient of positive numbers, truncated to 27 bits.
  static Pdp10 truncated_quotient(Pdp10 a, Pdp10 b);

  double value_ = 0;
};

/// SQRT by the library's method: a straight line and two Newton steps with truncated quotients. The result is
/// at most 0.598 units of the last place off, for any argument. The root of a negative number is that of its
/// magnitude (assumed: the library continued so after a message).
Pdp10 square_root(Pdp10 x);

/// EXP, ALOG and `**` with real exponent, correctly rounded except within about 2^-64 of themselves from a
/// half. The library of 1984 could be off by one unit of the last place; random errors of that size change no
/// printed digit of the published runs.
///
/// Assumed: ALOG and `**` take the magnitude of a negative argument or base; ALOG of 0 is the largest number,
/// negative; x**0 is 1; 0 to a negative power is the largest number.
Pdp10 exponential(Pdp10 x);
Pdp10 logarithm(Pdp10 x);
Pdp10 power(Pdp10 base, Pdp10 exponent);

/// INT: rounds towards zero, and to the nearest int beyond its range.
int truncated(Pdp10 x);

/// The 36 bits of the machine: sign, exponent plus 128 in 8 bits, fraction in 27. A negative number is the
/// two's complement of the whole word. 1.0 is octal 201400000000.
std::uint64_t word(Pdp10 x);

}  // namespace dashpad::spit1984
