#pragma once
/// Single precision of the 36-bit PDP-10 (DECSystem-10), on which the 1984 program ran.
///
/// A number is a fraction of 27 bits in [1/2, 1) times a power of two from 2^-128 to 2^127. Each sum,
/// difference, product and quotient is the exact one rounded to 27 bits, halves away from zero. If that is
/// beyond the largest number, the result is the largest with its sign, and below the smallest it is 0: what
/// the run-time system put in after its message. There is no infinity, no "not a number" and no negative
/// zero.
///
/// These rules, and the square root, were found by reproducing the printout of Appendix C. What is marked as
/// assumed never happens in that printout and was not checked.

#include <bit>
#include <compare>
#include <cstdint>
#include <stdexcept>

namespace dashpad::spit1984 {

/// The value is held as a double, which has room for 27 bits.
///
/// Why it is right to compute in double and round again: rounding to double keeps order, and every number
/// half-way between two of 27 bits is itself a double. So the first rounding never carries a result across
/// such a half; it can only land on one. Only then does the second rounding need to know on which side the
/// exact result was, and only then is the operation repeated in long double. There the answer is certain:
/// - a product of 27-bit numbers has 54 bits: exact;
/// - the sum or difference of two numbers that lands there has at most 56 bits, since they are at most a
///   factor of 2^29 apart: exact;
/// - a quotient is never a half, and differs from each by more than 2^-55 of itself: 64 bits tell.
class Pdp10 {
 public:
  constexpr Pdp10() = default;
  /// Rounds to 27 bits. A decimal constant is thereby rounded twice, which matters only where it lies within
  /// 2^-53 of itself from a half. Infinity is too large like any other number beyond the range.
  /// @throws std::invalid_argument if the value is not a number.
  constexpr Pdp10(double value) : Pdp10(rounded(value)) {
    if (value != value) throw std::invalid_argument("the PDP-10 has no word for what is not a number");
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

  /// Halves go away from zero: a carry out of the fraction goes into the exponent, which is next to it.
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
  /// `x` is a half and the double nearest to what `exact` tells the true place of.
  static Pdp10 rounded_half(double x, long double exact);
  /// f(x...) of the C library.
  template <class Function, class... Numbers>
  static Pdp10 rounded_function(Function f, Numbers... x);
  /// The quotient of positive numbers, cut off after 27 bits.
  static Pdp10 truncated_quotient(Pdp10 a, Pdp10 b);

  double value_ = 0;
};

/// SQRT by the method of the library: a straight line and two Newton steps, whose quotients are cut off and
/// not rounded. At most 0.598 units of the last place from the true root (of all arguments). The root of a
/// negative number is that of its magnitude (assumed: the library went on so after a message).
Pdp10 square_root(Pdp10 x);

/// EXP, ALOG and `**` with real exponent, correctly rounded (but for results within about 2^-64 of themselves
/// of a half, where 64 bits do not tell). The library of 1984 could be off by one unit of the last place;
/// random errors of one unit change no printed digit of the published runs.
///
/// Assumed: a negative argument of ALOG and a negative base count as their magnitudes; ALOG of 0 is the
/// largest number, negative; x**0 is 1; 0 to a negative power is the largest number.
Pdp10 exponential(Pdp10 x);
Pdp10 logarithm(Pdp10 x);
Pdp10 power(Pdp10 base, Pdp10 exponent);

/// INT: towards zero; the nearest int where the number is beyond all of them.
int truncated(Pdp10 x);

/// The 36 bits as the machine held them: sign, exponent plus 128 in 8 bits, fraction in 27. A negative number
/// is the two's complement of the whole word. 1.0 is octal 201400000000.
std::uint64_t word(Pdp10 x);

}  // namespace dashpad::spit1984
