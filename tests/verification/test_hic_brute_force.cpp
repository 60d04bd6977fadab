/// HIC against a search that knows nothing of it: a grid of windows in long double, refined by golden
/// section.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"

namespace dashpad::test {
namespace {

using Real = long double;

class BruteForce {
 public:
  explicit BruteForce(const Pulse& pulse) {
    const std::size_t size = pulse.time.size();
    velocity_.push_back(0);
    for (std::size_t i = 0; i < size; ++i) {
      time_.push_back(static_cast<Real>(pulse.time[i]) - pulse.time[0]);
      level_.push_back(static_cast<Real>(pulse.acceleration[i]) / standard_gravity);
      if (i == 0) continue;
      velocity_.push_back(velocity_.back() + (time_[i] - time_[i - 1]) * (level_[i] + level_[i - 1]) / 2);
    }
    constexpr int parts = 8;
    for (std::size_t i = 0; i + 1 < size; ++i)
      for (int k = 0; k < parts; ++k)
        grid_.push_back(time_[i] + (time_[i + 1] - time_[i]) * static_cast<Real>(k) / parts);
    grid_.push_back(time_.back());
  }

  /// Of the window from s1 to s2, in seconds after the first sample.
  [[nodiscard]] Real value(Real s1, Real s2) const {
    if (s1 < 0 || s2 > time_.back() || s2 <= s1) return 0;
    const Real mean = std::abs(velocity(s2) - velocity(s1)) / (s2 - s1);
    return (s2 - s1) * mean * mean * std::sqrt(mean);
  }

  [[nodiscard]] Real best(Real longest) const {
    return std::max(best_shorter(longest), best_as_long(longest));
  }

 private:
  [[nodiscard]] Real velocity(Real s) const {
    auto i = static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), s) - time_.begin());
    i = std::clamp<std::size_t>(i, 1, time_.size() - 1) - 1;
    const Real x = s - time_[i];
    return velocity_[i] + x * level_[i] + x * x / 2 * (level_[i + 1] - level_[i]) / (time_[i + 1] - time_[i]);
  }

  template <class F>
  static Real best_argument(Real low, Real high, F&& f) {
    const Real ratio = (std::sqrt(Real{5}) - 1) / 2;
    Real a = high - ratio * (high - low);
    Real b = low + ratio * (high - low);
    Real fa = f(a);
    Real fb = f(b);
    for (int i = 0; i < 45; ++i) {
      if (fa > fb) {
        high = b;
        b = a;
        fb = fa;
        fa = f(a = high - ratio * (high - low));
      } else {
        low = a;
        a = b;
        fa = fb;
        fb = f(b = low + ratio * (high - low));
      }
    }
    return (low + high) / 2;
  }

  /// Both ends on the grid; from each pair that no neighbour exceeds, uphill.
  [[nodiscard]] Real best_shorter(Real longest) const {
    const std::size_t size = grid_.size();
    std::vector<Real> table(size * size);
    Real highest = 0;
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t l = k + 1; l < size; ++l)
        if (grid_[l] - grid_[k] <= longest)
          highest = std::max(highest, table[k * size + l] = value(grid_[k], grid_[l]));
    Real found = highest;
    const auto below = [](std::size_t k) { return k == 0 ? 0 : k - 1; };
    const auto above = [size](std::size_t k) { return std::min(k + 1, size - 1); };
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t l = k + 1; l < size; ++l) {
        const Real here = table[k * size + l];
        bool top = here > 0.6L * highest;
        for (std::size_t m = below(k); top && m <= above(k); ++m)
          for (std::size_t n = below(l); n <= above(l); ++n) top = top && table[m * size + n] <= here;
        if (top) found = std::max(found, uphill(k, l, longest));
      }
    return found;
  }

  /// Along the begin, the end and both, by up to a step of the grid at a time.
  [[nodiscard]] Real uphill(std::size_t k, std::size_t l, Real longest) const {
    Real s1 = grid_[k];
    Real s2 = grid_[l];
    const Real step1 = grid_[std::min(k + 1, grid_.size() - 1)] - grid_[k == 0 ? 0 : k - 1];
    const Real step2 = grid_[std::min(l + 1, grid_.size() - 1)] - grid_[l == 0 ? 0 : l - 1];
    Real now = value(s1, s2);
    for (int round = 0; round < 100; ++round) {
      const auto improve = [&](Real low, Real high, Real move1, Real move2) {
        const auto f = [&](Real x) { return value(s1 + move1 * x, s2 + move2 * x); };
        Real best = 0;
        for (const Real x : {low, best_argument(low, high, f), high})
          if (f(x) > f(best)) best = x;
        s1 += move1 * best;
        s2 += move2 * best;
      };
      improve(-std::min(step1, longest - (s2 - s1)), step1, 1, 0);
      improve(-step2, std::min(step2, longest - (s2 - s1)), 0, 1);
      improve(-std::min(step1, step2), std::min(step1, step2), 1, 1);
      const Real before = now;
      now = value(s1, s2);
      if (now <= before * (1 + 1e-15L)) break;
    }
    return now;
  }

  /// Windows of the full length: they begin on the grid or end there, and are then moved.
  [[nodiscard]] Real best_as_long(Real longest) const {
    std::vector<Real> begins;
    for (const Real s : grid_)
      for (const Real begin : {s, s - longest})
        if (begin >= 0 && begin + longest <= time_.back()) begins.push_back(begin);
    std::sort(begins.begin(), begins.end());
    const auto at = [&](Real s) { return value(s, s + longest); };
    Real found = 0;
    for (const Real begin : begins) found = std::max(found, at(begin));
    for (std::size_t k = 0; k + 1 < begins.size(); ++k)
      if (at(begins[k]) > 0.7L * found)
        found = std::max(found, at(best_argument(begins[k], begins[k + 1], at)));
    return found;
  }

  std::vector<Real> time_, level_, velocity_;
  std::vector<Real> grid_;
};

/// Random samples: even or uneven, of one or both signs, rough, smooth or in steps.
Pulse random_pulse(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const int size = std::uniform_int_distribution(2, 40)(random);
  const bool even = unit(random) < 0.3;
  const int kind = std::uniform_int_distribution(0, 3)(random);
  const double lowest = unit(random) < 0.5 ? -500 : 0;
  Pulse pulse;
  double t = unit(random) < 0.5 ? 0 : 1000 * unit(random);
  double level = 500 * unit(random);
  for (int i = 0; i < size; ++i) {
    pulse.time.push_back(t);
    pulse.acceleration.push_back(std::max(level, lowest));
    t += even ? 1e-3 : std::pow(10, -2 - 3 * unit(random));
    if (kind == 0) level = 500 * (2 * unit(random) - 1);
    if (kind == 1) level += 200 * (2 * unit(random) - 1);
    if (kind == 2) level = unit(random) < 0.7 ? level : std::round(4 * unit(random)) * 100;
    if (kind == 3) level = 500 * std::exp(-std::pow((i - size * 0.4) / size * 5, 2));
  }
  return pulse;
}

TEST(BruteForceHic, IsRightForATriangle) {
  const BruteForce search({{1, 1.3, 2}, {0, standard_gravity, 0}});
  EXPECT_NEAR(static_cast<double>(search.best(10)), 4.0 / 7 * std::pow(5.0 / 7, 2.5), 1e-14);
  EXPECT_NEAR(static_cast<double>(search.best(0.2)), 0.2 * std::pow(0.9, 2.5), 1e-14);
}

TEST(BruteForceHic, AgreesForRandomPulses) {
  std::mt19937 random(12345);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Pulse pulse = random_pulse(random);
    const BruteForce search(pulse);
    const double duration = pulse.time.back() - pulse.time.front();
    std::uniform_real_distribution<double> logarithm(-2, 0.1);
    for (const double longest : {duration * std::pow(10, logarithm(random)), injury::unlimited_window}) {
      const auto expected = static_cast<double>(search.best(std::min<Real>(longest, duration)));
      const injury::Hic found = injury::hic(pulse, longest);
      ASSERT_NEAR(found.value, expected, 1e-9 * expected) << "pulse " << i << ", window " << longest;
      worst = std::max(worst, std::abs(found.value / expected - 1));
      // The window is one of that value.
      const double start = pulse.time.front();
      ASSERT_GE(found.begin, start);
      ASSERT_LE(found.end, pulse.time.back());
      ASSERT_LE(found.end - found.begin, longest * (1 + 1e-15) + 4e-16 * found.end);
      const double clock = 1e-15 * found.end / (found.end - found.begin);
      ASSERT_NEAR(static_cast<double>(search.value(Real{found.begin} - start, Real{found.end} - start)),
                  found.value, (1e-9 + clock) * expected);
    }
  }
  RecordProperty("worst", fmt::format("{:.1e}", worst));
}

}  // namespace
}  // namespace dashpad::test
