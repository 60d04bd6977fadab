/// The numbers of the PDP-10. Sources of truth: the rules of its arithmetic (27 bits, halves away from zero)
/// worked out here in whole numbers; for the functions, Boost.Multiprecision with 50 digits.

#include "dashpad/spit1984/pdp10.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace dashpad::spit1984 {
namespace {

using Whole = boost::multiprecision::int1024_t;
/// Without expression templates, which confuse clang-tidy.
using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

/// Every number of the machine is a whole number of these.
constexpr int grain = -155;

Whole in_grains(Pdp10 x) {
  int twos = 0;
  const double fraction = std::frexp(to_double(x), &twos);
  return x == 0 ? Whole(0) : Whole(static_cast<std::int64_t>(fraction * 0x1p27)) << (twos - 27 - grain);
}

enum class Rounding { nearest, truncated };

/// (numerator / denominator) 2^grain in 27 bits.
double in_27_bits(Whole numerator, Whole denominator, Rounding rounding = Rounding::nearest) {
  if (numerator == 0) return 0;
  const bool negative = (numerator < 0) != (denominator < 0);
  numerator = abs(numerator);
  denominator = abs(denominator);
  int twos = static_cast<int>(msb(numerator)) - static_cast<int>(msb(denominator)) - 27;
  (twos < 0 ? numerator : denominator) <<= std::abs(twos);  // the quotient is now between 2^26 and 2^28
  if (numerator >= denominator << 27) denominator <<= 1, ++twos;
  if (rounding == Rounding::nearest) numerator = 2 * numerator + denominator, denominator *= 2;
  const double magnitude = std::ldexp(static_cast<double>(Whole(numerator / denominator)), twos + grain);
  const double limited = magnitude < 0x1p-129 ? 0 : std::min(magnitude, (1 - 0x1p-27) * 0x1p127);
  return negative ? -limited : limited;
}

double sum(Pdp10 a, Pdp10 b) { return in_27_bits(in_grains(a) + in_grains(b), 1); }
double product(Pdp10 a, Pdp10 b) { return in_27_bits(in_grains(a) * in_grains(b), Whole(1) << -grain); }
double quotient(Pdp10 a, Pdp10 b, Rounding rounding = Rounding::nearest) {
  return in_27_bits(in_grains(a) << -grain, in_grains(b), rounding);
}

class Samples {
 public:
  /// Any fraction; every fourth is within a few units of a power of two, every fourth has few bits.
  Pdp10 number(int min_exponent, int max_exponent) {
    auto fraction = static_cast<std::int64_t>(uniform(1 << 26, (1 << 27) - 1));
    const int kind = uniform(0, 3);
    if (kind == 0) fraction = (1 << 26) + uniform(-2, 2);
    if (kind == 1) fraction &= ~((std::int64_t{1} << uniform(0, 26)) - 1);
    const double magnitude =
        std::ldexp(static_cast<double>(fraction), uniform(min_exponent, max_exponent) - 27);
    return uniform(0, 1) == 0 ? magnitude : -magnitude;
  }
  double real(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int uniform(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

 private:
  std::mt19937_64 random_{1984};
};

struct Pair {
  Pdp10 a, b;
};

/// Exponents of all distances; half of the pairs are at most 30 apart.
std::vector<Pair> pairs(int count, int range) {
  Samples samples;
  std::vector<Pair> result;
  for (int i = 0; i < count; ++i) {
    const int exponent = samples.uniform(-range, range);
    const Pdp10 a = samples.number(exponent, exponent);
    const bool near = i % 2 == 0;
    result.push_back({a, samples.number(near ? std::max(-128, exponent - 30) : -range,
                                        near ? std::min(127, exponent + 30) : range)});
  }
  return result;
}

TEST(Pdp10, RoundsSumsProductsAndQuotientsExactly) {
  for (const auto& [a, b] : pairs(100'000, 60)) {
    ASSERT_EQ(to_double(a + b), sum(a, b)) << std::hexfloat << to_double(a) << " + " << to_double(b);
    ASSERT_EQ(to_double(a - b), sum(a, -b)) << std::hexfloat << to_double(a) << " - " << to_double(b);
    ASSERT_EQ(to_double(a * b), product(a, b)) << std::hexfloat << to_double(a) << " * " << to_double(b);
    ASSERT_EQ(to_double(a / b), quotient(a, b)) << std::hexfloat << to_double(a) << " / " << to_double(b);
  }
}

TEST(Pdp10, KeepsWithinItsRange) {
  for (const auto& [a, b] : pairs(5'000, 127)) {
    ASSERT_EQ(to_double(a + b), sum(a, b)) << std::hexfloat << to_double(a) << " + " << to_double(b);
    ASSERT_EQ(to_double(a * b), product(a, b)) << std::hexfloat << to_double(a) << " * " << to_double(b);
    ASSERT_EQ(to_double(a / b), quotient(a, b)) << std::hexfloat << to_double(a) << " / " << to_double(b);
  }
}

TEST(Pdp10, RoundsHalvesAwayFromZero) {
  const Pdp10 half = 0x1p-27;  // of the last place of numbers in [1, 2)
  Samples samples;
  for (int i = 0; i < 1000; ++i) {
    const Pdp10 x = 1 + samples.uniform(0, (1 << 26) - 1) * 0x1p-26;
    EXPECT_EQ(to_double(x + half), to_double(x) + 0x1p-26);
    EXPECT_EQ(to_double(-x - half), -to_double(x) - 0x1p-26);
    const Pdp10 short_of_half = (1 - 0x1p-27) * 0x1p-27;
    EXPECT_EQ(to_double(x + short_of_half), to_double(x));
    EXPECT_EQ(to_double(-x - short_of_half), -to_double(x));
    EXPECT_EQ(Pdp10(to_double(x) + 0x1p-27), x + half);
    EXPECT_EQ(Pdp10(-to_double(x) - 0x1p-27), -x - half);
  }
  EXPECT_EQ(to_double(Pdp10(3) * (1 + 0x1p-26)), 3 + 0x1p-24);    // 3 + 1.5 units of 2^-25
  EXPECT_EQ(to_double(Pdp10(-3) * (1 + 0x1p-26)), -3 - 0x1p-24);  // and below zero
}

/// To 53 bits first, the difference would be 1 - 2^-28, half-way between 1 - 2^-27 and 1, and become 1.
TEST(Pdp10, RoundsFromTheExactResultAndNotFromTheDouble) {
  EXPECT_EQ(to_double(Pdp10(1) - (0x1p-28 + 0x1p-54)), 1 - 0x1p-27);
  EXPECT_EQ(to_double(Pdp10(-1) + (0x1p-28 + 0x1p-54)), -1 + 0x1p-27);
  EXPECT_EQ(to_double(Pdp10(1) - 0x1p-28), 1);
}

/// Products whose 54 bits end in a zero and 26 ones: the double is a half, the exact product is below it.
/// Such pairs are rare, so they are made: any odd a, and the b for which a * b = 2^26 - 1 modulo 2^27.
TEST(Pdp10, RoundsProductsThatTheDoubleTakesForHalves) {
  Samples samples;
  int found = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto a = static_cast<std::uint64_t>(samples.uniform(1 << 26, (1 << 27) - 1)) | 1;
    std::uint64_t inverse = a;
    for (int step = 0; step < 5; ++step) inverse *= 2 - a * inverse;
    const std::uint64_t b = (inverse * ((1ULL << 26) - 1)) & ((1ULL << 27) - 1);
    if (b < (1ULL << 26) || a * b < (1ULL << 53)) continue;
    ++found;
    const Pdp10 x = static_cast<double>(a);
    const Pdp10 y = static_cast<double>(b);
    ASSERT_EQ(to_double(x * y), product(x, y)) << a << " * " << b;
    ASSERT_NE(to_double(x * y), to_double(Pdp10(to_double(x) * to_double(y)))) << "not such a pair";
  }
  EXPECT_GT(found, 1000);
}

/// The same for quotients: any odd b, and the a for which 2^27 a = -1 modulo b. The quotient is then less
/// than a half by 1/(2^27 b), too little for the double to tell.
TEST(Pdp10, RoundsQuotientsThatTheDoubleTakesForHalves) {
  Samples samples;
  int found = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t b = samples.uniform(1 << 26, (1 << 27) - 1) | 1;
    std::int64_t a = b - 1;  // -1 modulo b, to be halved 27 times
    for (int halving = 0; halving < 27; ++halving) a = (a % 2 == 0 ? a : a + b) / 2;
    a += b;
    if (a >= 1 << 27) continue;
    ++found;
    const Pdp10 x = static_cast<double>(a);
    const Pdp10 y = static_cast<double>(b);
    ASSERT_EQ(to_double(x / y), quotient(x, y)) << a << " / " << b;
    ASSERT_NE(to_double(x / y), to_double(Pdp10(to_double(x) / to_double(y)))) << "not such a pair";
  }
  EXPECT_GT(found, 1000);
}

TEST(Pdp10, EndsAtItsLargestAndSmallestNumbers) {
  const Pdp10 largest = Pdp10::largest();
  const Pdp10 smallest = Pdp10::smallest();
  EXPECT_EQ(to_double(largest), (1 - 0x1p-27) * 0x1p127);
  EXPECT_EQ(to_double(smallest), 0x1p-129);
  EXPECT_EQ(largest + largest, largest);
  EXPECT_EQ(-largest - largest, -largest);
  EXPECT_EQ(largest * -2, -largest);
  EXPECT_EQ(largest + 0x1p98, largest);
  EXPECT_EQ(largest + 0x1p99, largest);  // half a unit: rounds to 2^127, which is beyond
  EXPECT_EQ(smallest / 2, 0);
  EXPECT_EQ(smallest * smallest, 0);
  EXPECT_EQ(smallest * 1.5 - smallest, 0);
  EXPECT_EQ(smallest * (1 - 0x1p-27), 0);
  EXPECT_EQ(Pdp10(0x1p-130), 0);
  EXPECT_EQ(Pdp10(-1e-300), 0);
  EXPECT_EQ(Pdp10(1e300), largest);
  EXPECT_EQ(Pdp10(-std::numeric_limits<double>::max()), -largest);
  EXPECT_EQ(Pdp10(-std::numeric_limits<double>::infinity()), -largest);
  EXPECT_THROW(Pdp10{std::numeric_limits<double>::quiet_NaN()}, std::invalid_argument);
  EXPECT_EQ(Pdp10(3) / 0, largest);
  EXPECT_EQ(Pdp10(-3) / 0, -largest);
  EXPECT_EQ(Pdp10(0) / 0, largest);
}

TEST(Pdp10, HasNoNegativeZero) {
  const Pdp10 zero;
  const Pdp10 one = 1;
  for (const Pdp10 x :
       {-zero, zero * -one, -one * zero, zero / -one, one - one, -one + one, Pdp10(-0.0), -abs(zero),
        -Pdp10::smallest() / 2, Pdp10(-1e-99), square_root(-zero), logarithm(one)})
    EXPECT_FALSE(std::signbit(to_double(x)));
}

TEST(Pdp10, IsMadeOfWholeNumbersAndDecimals) {
  EXPECT_EQ(to_double(Pdp10()), 0);
  EXPECT_EQ(to_double(Pdp10(-7)), -7);
  EXPECT_EQ(to_double(Pdp10((1 << 27) + 1)), (1 << 27) + 2);
  EXPECT_EQ(to_double(Pdp10(-(1 << 27) - 1)), -(1 << 27) - 2);
  EXPECT_EQ(to_double(Pdp10(std::numeric_limits<int>::max())), 0x1p31);
  EXPECT_EQ(to_double(Pdp10(0.675)), 90596966 * 0x1p-27);   // 0.675 * 2^27 = 90596966.4
  EXPECT_EQ(to_double(Pdp10(-0.1)), -107374182 * 0x1p-30);  // 0.1 * 2^30 = 107374182.4
}

TEST(Pdp10, Compares) {
  const Pdp10 a = -2;
  const Pdp10 b = 0.5;
  EXPECT_TRUE(a < b && a <= b && b > a && b >= a && a != b && a == a && a <= a);
  EXPECT_FALSE(a > b || a >= b || b < a || b <= a || a == b || a != a || a < a);
  EXPECT_EQ(abs(a), 2);
  EXPECT_EQ(abs(b), b);
  EXPECT_EQ(-a, 2);
}

TEST(Pdp10, TruncatesTowardsZero) {
  EXPECT_EQ(truncated(2.999), 2);
  EXPECT_EQ(truncated(-2.999), -2);
  EXPECT_EQ(truncated(-0.5), 0);
  EXPECT_EQ(truncated(134217727), 134217727);
  EXPECT_EQ(truncated(0x1p31), std::numeric_limits<int>::max());
  EXPECT_EQ(truncated(-0x1p40), std::numeric_limits<int>::min());
}

/// By hand from the format; 1.0, -1.0 and the ends are in every description of the machine.
TEST(Pdp10, HasTheWordsOfTheMachine) {
  EXPECT_EQ(word(0), 0U);
  EXPECT_EQ(word(1), 0'201'400'000'000U);
  EXPECT_EQ(word(-1), 0'576'400'000'000U);
  EXPECT_EQ(word(0.5), 0'200'400'000'000U);
  EXPECT_EQ(word(10), 0'204'500'000'000U);
  EXPECT_EQ(word(-1.5), 0'576'200'000'000U);
  EXPECT_EQ(word(0.1), 0'175'631'463'146U);  // 0.8 * 2^27 = octal 631463146.31...
  EXPECT_EQ(word(0.2), 0'176'631'463'146U);
  EXPECT_EQ(word(Pdp10::largest()), 0'377'777'777'777U);
  EXPECT_EQ(word(-Pdp10::largest()), 0'400'000'000'001U);
  EXPECT_EQ(word(Pdp10::smallest()), 0'000'400'000'000U);
  EXPECT_EQ(word(-Pdp10::smallest()), 0'777'400'000'000U);
}

/// The method of the library, for an argument in [1/4, 1), in whole numbers.
double root_by_the_method(Pdp10 f) {
  const bool lower = f < 0.5;
  double root = sum(product(lower ? 0.828125 : 0.5859375, f), lower ? 0.29730225 : 0.4208984375);
  for (int step = 0; step < 2; ++step) root = sum(root, quotient(f, root, Rounding::truncated)) / 2;
  return root;
}

/// Distance from the true root in units of the last place.
double error_of_root(Pdp10 x) {
  const double root = to_double(square_root(x));
  const Real difference = (root - sqrt(Real(to_double(x)))) / std::ldexp(1, std::ilogb(root) - 26);
  return static_cast<double>(difference);
}

TEST(Pdp10, TakesSquareRootsByTheMethodOfTheLibrary) {
  Samples samples;
  for (int i = 0; i < 10'000; ++i) {
    const Pdp10 x = abs(samples.number(-1, 0));
    const int fours = samples.uniform(-63, 63);
    ASSERT_EQ(to_double(square_root(x)), root_by_the_method(x)) << std::hexfloat << to_double(x);
    ASSERT_EQ(to_double(square_root(std::ldexp(to_double(x), 2 * fours))),
              std::ldexp(root_by_the_method(x), fours));
    ASSERT_LT(std::abs(error_of_root(x)), 0.598) << std::hexfloat << to_double(x);
  }
}

/// The worst of all arguments: the 2^27 of [1/4, 1) were tried in turn.
TEST(Pdp10, HasSquareRootsWithinAUnitOfTheTrueOnes) {
  EXPECT_NEAR(error_of_root(0x1.0000e78p-1), 0.597128, 1e-6);
}

TEST(Pdp10, TakesSquareRootsOfEverySign) {
  EXPECT_EQ(square_root(0), 0);
  EXPECT_EQ(square_root(-9), square_root(9));
}

void expect_rounded(Pdp10 machine, const Real& truth) {
  int twos = 0;
  const Real fraction = frexp(Real(abs(truth)), &twos);
  const double expected = std::ldexp(static_cast<double>(floor(ldexp(fraction, 27) + Real(0.5))), twos - 27);
  ASSERT_EQ(to_double(machine), truth < 0 ? -expected : expected);
}
void expect_exponential(Pdp10 x) { expect_rounded(exponential(x), exp(Real(to_double(x)))); }
void expect_logarithm(Pdp10 x) { expect_rounded(logarithm(x), log(Real(to_double(x)))); }
void expect_power(Pdp10 x, Pdp10 y) {
  expect_rounded(power(x, y), pow(Real(to_double(x)), Real(to_double(y))));
}

TEST(Pdp10, RoundsTheFunctionsCorrectly) {
  Samples samples;
  for (int i = 0; i < 2'000; ++i) {
    expect_exponential(samples.real(-50, 10));
    expect_logarithm(std::pow(10, samples.real(-3, 4)));
    expect_power(std::pow(10, samples.real(-9, 0)), samples.real(-1, 3));
  }
}

/// Where the nearest double is a half, and the true value is it, or just above or below it.
TEST(Pdp10, RoundsTheFunctionsCorrectlyAtHalves) {
  for (const double x : {1 - 0x1p-27, 1.0, 1 + 0x1p-26}) {
    expect_exponential(x * 0x1p-27);
    expect_exponential(-x * 0x1p-28);
    expect_power(1 - 0x1p-27, x / 2);
    expect_power(1 + 0x1p-26, x / 2);
  }
  for (std::int64_t odd = 513; odd < 645; odd += 2)  // cubes of 28 bits
    EXPECT_EQ(to_double(power(static_cast<double>(odd * odd), 1.5)),
              static_cast<double>(odd * odd * odd + 1));
}

TEST(Pdp10, HasThePowersAndLogarithmsOfTheEnds) {
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(100), Pdp10::largest());
  EXPECT_EQ(exponential(100000), Pdp10::largest());
  EXPECT_EQ(exponential(-100), 0);
  EXPECT_EQ(exponential(-100000), 0);
  EXPECT_EQ(logarithm(1), 0);
  EXPECT_EQ(logarithm(0), -Pdp10::largest());
  EXPECT_EQ(logarithm(-2), logarithm(2));
  EXPECT_EQ(power(0, 0.675), 0);
  EXPECT_EQ(power(0, 0), 1);
  EXPECT_EQ(power(0, -1), Pdp10::largest());
  EXPECT_EQ(power(4, 0.5), 2);
  EXPECT_EQ(power(4, -1.5), 0.125);
  EXPECT_EQ(power(-4, 0.5), 2);
  EXPECT_EQ(power(1e-30, 3), 0);
  EXPECT_EQ(power(1e30, 3), Pdp10::largest());
}

}  // namespace
}  // namespace dashpad::spit1984
