/// The root finder on functions that the solver may meet: kinks, infinite slopes, plateaus and jumps.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "model/root.hpp"

namespace dashpad {
namespace {

struct Nasty {
  const char* name;
  std::function<double(double)> f;  ///< increasing on [0, 1]
  double root;
};

const std::vector<Nasty> functions{
    {"line", [](double x) { return x - 0.3; }, 0.3},
    {"infinite slope at the root", [](double x) { return std::cbrt(x - 0.3); }, 0.3},
    {"steep power", [](double x) { return std::copysign(std::pow(std::abs(x - 0.3), 0.05), x - 0.3); }, 0.3},
    {"flat at the root", [](double x) { return std::pow(x - 0.3, 9); }, 0.3},
    {"plateau before the root", [](double x) { return x < 0.6 ? -1e-3 : (x - 0.7) * 100; }, 0.7},
    {"jump at the root", [](double x) { return x < 0.3 ? -1.0 : 2.0; }, 0.3},
    {"jump and slope", [](double x) { return x < 0.3 ? x - 5 : x + 1e3; }, 0.3},
    {"kink", [](double x) { return x < 0.3 ? 1e-6 * (x - 0.3) : 1e6 * (x - 0.3); }, 0.3},
    {"close to the low end", [](double x) { return x - 1e-12; }, 1e-12},
    {"close to the high end", [](double x) { return x - (1 - 1e-12); }, 1 - 1e-12},
    {"exponential", [](double x) { return std::exp(50 * x) - std::exp(40.0); }, 0.8},
};

constexpr auto only_zero = [](double value) { return value == 0; };

class Roots : public testing::TestWithParam<Nasty> {};

TEST_P(Roots, AreFoundFromAnyGuessWithAnySlope) {
  const Nasty& nasty = GetParam();
  for (const double guess : {0.0, 1e-9, 0.31, 0.5, 1.0, -3.0, 7.0})
    for (const double slope : {1e-9, 1.0, 1e9}) {
      int calls = 0;
      double last = std::numeric_limits<double>::quiet_NaN();
      RootSearch search;
      search.high = 1;
      search.guess = guess;
      search.slope = slope;
      search.resolution = 1e-15;
      const Root root = find_root(
          [&](double x) {
            ++calls;
            last = x;
            EXPECT_GE(x, 0);
            EXPECT_LE(x, 1);
            return nasty.f(x);
          },
          only_zero, search);
      const std::string where = "guess " + std::to_string(guess) + ", slope " + std::to_string(slope);
      EXPECT_EQ(root.place, RootPlace::inside) << where;
      // A flat root is as good as its value.
      EXPECT_TRUE(std::abs(root.x - nasty.root) < 1e-11 || std::abs(nasty.f(root.x)) < 1e-60)
          << where << ": " << root.x;
      EXPECT_EQ(last, root.x) << "the last call is at the root, " << where;
      EXPECT_LT(calls, 220) << where;
    }
}

INSTANTIATE_TEST_SUITE_P(Functions, Roots, testing::ValuesIn(functions), [](const auto& parameter) {
  std::string name = parameter.param.name;
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
});

RootSearch between(double low, double high) {
  RootSearch search;
  search.low = low;
  search.high = high;
  search.guess = low + (high - low) / 3;
  search.resolution = 1e-15;
  return search;
}

TEST(root, says_where_there_is_none) {
  EXPECT_EQ(find_root([](double x) { return x + 1; }, only_zero, between(0, 1)).place,
            RootPlace::at_or_below_low);
  EXPECT_EQ(find_root([](double x) { return x - 2; }, only_zero, between(0, 1)).place,
            RootPlace::at_or_above_high);
}

TEST(root, stops_at_the_tolerance_asked_for) {
  int calls = 0;
  const Root root = find_root([&](double x) { return ++calls, x - 0.5; },
                              [](double value) { return std::abs(value) <= 1e-3; }, between(0, 1));
  EXPECT_NEAR(root.x, 0.5, 1e-3);
  EXPECT_LE(calls, 3);
}

TEST(root, strides_down_without_a_low_end) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double place : {-1e-9, -0.5, -3.0, -1e4}) {
    RootSearch search;
    search.low = -infinity;
    search.high = 0;
    search.high_is_positive = true;
    search.guess = -0.1;
    search.stride = 0.2;
    search.resolution = 1e-12 * std::abs(place);
    const Root root = find_root([&](double x) { return std::atan(x - place); }, only_zero, search);
    EXPECT_EQ(root.place, RootPlace::inside);
    EXPECT_NEAR(root.x, place, 1e-10 * std::abs(place));
  }
}

}  // namespace
}  // namespace dashpad
