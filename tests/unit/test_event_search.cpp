#include "impact/event_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace dashpad {
namespace {

constexpr double nowhere = -infinite;

TEST(event_search, brackets_a_change_of_sign) {
  for (const double place : {0.1, 0.3, 0.999}) {
    int calls = 0;
    const auto value = [&](double x) { return ++calls, std::cos(x) - std::cos(place); };
    const auto [low, high] = bracket_event(value, {.step = 1,
                                                   .precision = 1e-9,
                                                   .value_now = 1 - std::cos(place),
                                                   .value_then = std::cos(1) - std::cos(place)});
    EXPECT_LE(low, place + 1e-9);
    EXPECT_GE(high, place - 1e-9);
    EXPECT_LE(high - low, 1e-9);
    EXPECT_LT(calls, 40);
  }
}

TEST(event_search, finds_the_end_of_what_has_a_solution) {
  const auto value = [](double x) { return x < 0.4 ? 1 - x : nowhere; };
  const auto [low, high] = bracket_event(
      value, {.step = 1, .precision = 1e-6, .value_now = 1, .value_then = nowhere, .guess = 0.7});
  EXPECT_LT(low, 0.4);
  EXPECT_GE(high, 0.4);
  EXPECT_LE(high - low, 1e-6);
}

TEST(event_search, stops_where_nothing_is_before_the_event) {
  const auto [low, high] =
      bracket_event([](double) { return -1.0; }, {.step = 1, .precision = 1e-6, .value_then = -1});
  EXPECT_EQ(low, 0);
  EXPECT_LE(high, 1e-6);
}

}  // namespace
}  // namespace dashpad
