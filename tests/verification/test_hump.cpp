/// HIC and clips of pulses with one peak, for which there is a walk of their own, against the search over all
/// pulses and against windows tried one by one.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dashpad/injury/metrics.hpp"
#include "injury/hic_search.hpp"

namespace dashpad {
namespace {

using injury::hump_of;

class Humps {
 public:
  /// Rises and falls by random steps, steep and flat ones; from and to 0, or from and to any level.
  Pulse next(bool from_zero) {
    const int rises = whole(0, 12), falls = whole(rises == 0 ? 1 : 0, 12);
    std::vector<double> left = levels(rises), right = levels(falls);
    if (from_zero && rises > 0) left.front() = 0;
    if (from_zero && falls > 0) right.front() = 0;
    Pulse pulse;
    double time = number(-0.1, 0.1);
    const auto add = [&](double level) {
      pulse.time.push_back(time);
      pulse.acceleration.push_back(level);
      time += std::exp(number(-9, -5));
    };
    for (const double level : left) add(level);
    add(1000);
    std::reverse(right.begin(), right.end());
    for (const double level : right) add(level);
    return pulse;
  }
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

 private:
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  std::vector<double> levels(int count) {
    std::vector<double> all(static_cast<std::size_t>(count));
    for (double& level : all) level = whole(0, 1) == 0 ? number(0, 999) : std::exp(number(-5, 6.9));
    std::sort(all.begin(), all.end());
    return all;
  }
  std::mt19937_64 random_{20240229};
};

/// The same pulse with rest after it: level stretches make it none of the humps.
Pulse with_rest(Pulse pulse) {
  for (int i = 1; i <= 2; ++i) {
    pulse.time.push_back(pulse.time.back() + 1e-3);
    pulse.acceleration.push_back(0);
  }
  return pulse;
}

Pulse turned(Pulse pulse) {
  for (double& a : pulse.acceleration) a = -a;
  return pulse;
}

TEST(Hump, is_known) {
  EXPECT_EQ(hump_of({{0, 1, 2}, {0, 3, 1}})->peak, 1U);
  EXPECT_EQ(hump_of({{0, 1, 2}, {0, -3, -1}})->sign, -1);
  EXPECT_EQ(hump_of({{0, 1}, {3, 1}})->peak, 0U);
  EXPECT_EQ(hump_of({{0, 1}, {1, 3}})->peak, 1U);
  EXPECT_FALSE(hump_of({{0, 1, 2, 3}, {0, 3, 3, 1}}));
  EXPECT_FALSE(hump_of({{0, 1, 2, 3, 4}, {0, 3, 1, 2, 0}}));
  EXPECT_FALSE(hump_of({{0, 1, 2}, {-1, 3, 1}}));
  EXPECT_FALSE(hump_of({{0, 1, 2}, {0, 3, -1}}));
  EXPECT_FALSE(hump_of({{0, 1}, {0, 0}}));
}

TEST(Hump, has_the_hic_and_clips_of_the_search_over_all_pulses) {
  Humps humps;
  int compared = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Pulse pulse = humps.next(true);
    // A pulse that does not end at rest is another one with rest after it.
    if (!hump_of(pulse) || pulse.acceleration.back() != 0) continue;
    ++compared;
    const Pulse longer = with_rest(pulse);
    ASSERT_FALSE(hump_of(longer));
    const double length = pulse.time.back() - pulse.time.front();
    for (const double window : {injury::unlimited_window, length * humps.number(0.01, 1), 15e-3}) {
      const injury::Hic got = injury::hic(pulse, window), expected = injury::hic(longer, window);
      ASSERT_NEAR(got.value, expected.value, 1e-11 * expected.value) << i << " window " << window;
      ASSERT_EQ(injury::hic(turned(pulse), window).value, got.value);
      ASSERT_LE(got.end - got.begin, window * (1 + 1e-12));
    }
    // The search forgives rounding of the times: 8 units, on slopes up to 1e7.
    const double duration = length * humps.number(0.001, 0.999);
    const injury::Clip contiguous = injury::contiguous_clip(pulse, duration),
                       cumulative = injury::cumulative_clip(pulse, duration);
    ASSERT_NEAR(contiguous.level, injury::contiguous_clip(longer, duration).level, 1e-8) << i;
    ASSERT_NEAR(contiguous.begin, injury::contiguous_clip(longer, duration).begin, 1e-9) << i;
    ASSERT_NEAR(contiguous.end, injury::contiguous_clip(longer, duration).end, 1e-9) << i;
    ASSERT_NEAR(cumulative.level, injury::cumulative_clip(longer, duration).level, 1e-8) << i;
    ASSERT_NEAR(cumulative.begin, injury::cumulative_clip(longer, duration).begin, 1e-9) << i;
    ASSERT_NEAR(cumulative.end, injury::cumulative_clip(longer, duration).end, 1e-9) << i;
  }
  EXPECT_GT(compared, 5000);
}

double velocity_at(const Pulse& pulse, double time) {
  double sum = 0;
  for (std::size_t i = 1; i < pulse.time.size() && pulse.time[i - 1] < time; ++i) {
    const double step = pulse.time[i] - pulse.time[i - 1], part = std::min(time - pulse.time[i - 1], step);
    const double slope = (pulse.acceleration[i] - pulse.acceleration[i - 1]) / step;
    sum += part * (pulse.acceleration[i - 1] + slope * part / 2);
  }
  return sum;
}

/// No window of a fine grid is better than the one that was found, and that one is as good as it is said to
/// be.
TEST(Hump, has_the_hic_of_its_best_window) {
  Humps humps;
  for (int i = 0; i < 300; ++i) {
    const Pulse pulse = humps.next(false);
    if (!hump_of(pulse)) continue;
    const double begin = pulse.time.front(), length = pulse.time.back() - begin;
    const double window = i % 2 == 0 ? injury::unlimited_window : length * humps.number(0.05, 0.95);
    const injury::Hic found = injury::hic(pulse, window);
    const auto value = [&](double from, double to) {
      return injury::hic_search::criterion(to - from,
                                           (velocity_at(pulse, to) - velocity_at(pulse, from)) / 9.80665);
    };
    EXPECT_NEAR(value(found.begin, found.end), found.value, 1e-9 * found.value) << i;
    constexpr int steps = 60;
    for (int from = 0; from < steps; ++from)
      for (int to = from + 1; to <= steps && (to - from) * length / steps <= window; ++to)
        ASSERT_LE(value(begin + from * length / steps, begin + to * length / steps),
                  found.value * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace dashpad
