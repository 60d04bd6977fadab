// The portable elementary functions, against those of the C library in long double.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <regex>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "shared/generated_text.hpp"

namespace dashpad::test {
namespace {

namespace fs = std::filesystem;

struct Range {
  double from = 0;
  double to = 0;
  bool by_powers_of_ten = false;
};

/// Largest error at 100,000 places, in units in the last place.
template <class F, class Exact>
double largest_error(F&& f, Exact&& exact, Range range) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(range.from, range.to);
  double largest = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = range.by_powers_of_ten ? std::pow(10, place(random)) : place(random);
    const auto right = static_cast<long double>(exact(static_cast<long double>(x)));
    const double size = std::abs(static_cast<double>(right));
    const double unit = std::nextafter(size, infinite) - size;
    largest = std::max(largest, static_cast<double>(std::abs((f(x) - right) / unit)));
  }
  return largest;
}

TEST(PortableMath, RoundsAsItsHeaderSays) {
  const auto expl = [](long double x) { return std::exp(x); };
  EXPECT_LE(largest_error(portable::exp, expl, {-700, 700}), 1.01);
  EXPECT_LE(largest_error(portable::exp, expl, {700, 709}), 4);
  EXPECT_LE(largest_error(portable::exp, expl, {-1, 1}), 1.01);
  const auto logl = [](long double x) { return std::log(x); };
  EXPECT_LE(largest_error(portable::log, logl, {-300, 300, true}), 1);
  EXPECT_LE(largest_error(portable::log, logl, {0.5, 1.5}), 1);
  const auto expm1l = [](long double x) { return std::expm1(x); };
  EXPECT_LE(largest_error(portable::expm1, expm1l, {-12, 2, true}), 4);
  EXPECT_LE(largest_error(portable::expm1, expm1l, {-5, 5}), 4);
  const auto log1pl = [](long double x) { return std::log1p(x); };
  EXPECT_LE(largest_error(portable::log1p, log1pl, {-12, 12, true}), 3);
  EXPECT_LE(largest_error(portable::log1p, log1pl, {-0.999, 1}), 3);
  EXPECT_LE(largest_error(portable::sin, [](long double x) { return std::sin(x); }, {-3, 3}), 3);
  EXPECT_LE(largest_error(portable::cos, [](long double x) { return std::cos(x); }, {-1.5, 1.5}), 3);
  EXPECT_LE(largest_error(portable::tan, [](long double x) { return std::tan(x); }, {-1.5, 1.5}), 6);
  EXPECT_LE(largest_error(portable::asin, [](long double x) { return std::asin(x); }, {-1, 1}), 3);
  for (const double exponent : {0.166, 0.5, 2.0, -3.7}) {
    const double most = 2 + 2 * std::abs(exponent) * std::log(10) * 3;
    const auto powl = [&](long double x) { return std::pow(x, static_cast<long double>(exponent)); };
    const auto pow = [&](double x) { return portable::pow(x, exponent); };
    EXPECT_LE(largest_error(pow, powl, {-3, 3, true}), most) << exponent;
  }
}

TEST(PortableMath, ScaledErrorFunction) {
  // Of a long double, erfc and exp(x^2) have some 19 digits each.
  const auto exact = [](long double x) { return std::exp(x * x) * std::erfc(x); };
  EXPECT_LE(largest_error(portable::scaled_erfc, exact, {0, 10}), 45);  // 1e-14
}

TEST(PortableMath, Limits) {
  EXPECT_EQ(portable::exp(710), infinite);
  EXPECT_EQ(portable::exp(infinite), infinite);
  EXPECT_EQ(portable::exp(-infinite), 0);
  EXPECT_EQ(portable::exp(-800), 0);
  EXPECT_EQ(portable::exp(0), 1);
  EXPECT_EQ(portable::log(0), -infinite);
  EXPECT_EQ(portable::log(infinite), infinite);
  EXPECT_EQ(portable::log(1), 0);
  EXPECT_EQ(portable::log1p(-1), -infinite);
  EXPECT_EQ(portable::expm1(-infinite), -1);
  EXPECT_EQ(portable::expm1(0), 0);
  EXPECT_EQ(portable::pow(0, 0.7), 0);
  EXPECT_EQ(portable::pow(0, -0.7), infinite);
  EXPECT_EQ(portable::pow(0, 0), 1);
  EXPECT_EQ(portable::pow(0.3, 1), 0.3);
  for (const double bad :
       {portable::log(-1), portable::log1p(-2), portable::exp(no_value), portable::log(no_value)})
    EXPECT_TRUE(std::isnan(bad));
}

// What the solver and the intervals are computed with has no function of the C library that rounds in its own
// way.
TEST(PortableMath, IsWhatTheModelUses) {
  const std::regex call(
      R"(std::(exp|exp2|expm1|log|log2|log10|log1p|pow|sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|)"
      R"(erfc?|lgamma|tgamma|cbrt)\()");
  const fs::path root = DASHPAD_SOURCE_DIR;
  int files = 0;
  for (const char* folder :
       {"src/model", "src/impact", "src/uncertainty", "include/dashpad/model", "include/dashpad/impact"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      EXPECT_FALSE(std::regex_search(text_of(entry.path()), call)) << entry.path();
    }
  EXPECT_GT(files, 100);
}

}  // namespace
}  // namespace dashpad::test
