#pragma once
/// The slip rate u of a foam, which follows the strain rate with a lag of a small strain.
///
///   dg/dt = rate - u,   u = u0 (exp(|g| / c) - 1) sgn g                          (theory.md, Eq. 34)
///
/// g is the elastic strain of the rate's stress, the same for all columns below a nose. c is a twentieth of
/// the lag strain, u0 a thousandth of the slowest tested rate. The equation is linear in z = exp(-|g| / c),
/// and its solution exact while the rate changes evenly. Rates in 1/s.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct SlipScale {
  double strain = 2.5e-4;  ///< c
  double rate = 1e-5;      ///< u0, 1/s

  /// z = exp(-|g| / c) and the sign of g.
  struct State {
    double z = 1;
    double side = 1;
  };
  [[nodiscard]] State state_of(double g) const {
    return {portable::exp(-std::abs(g) / strain), g < 0 ? -1.0 : 1.0};
  }
  [[nodiscard]] double strain_of(State state) const { return -state.side * strain * portable::log(state.z); }

  /// u, 1/s.
  [[nodiscard]] double slip_rate(double g) const {
    return std::copysign(rate * portable::expm1(std::abs(g) / strain), g);
  }
  [[nodiscard]] double slip_rate(State state) const { return state.side * rate * (1 - state.z) / state.z; }

  /// g after a time at a constant strain rate.
  [[nodiscard]] double after(double g, double strain_rate, double time) const {
    return after(g, strain_rate, strain_rate, time);
  }
  /// The same while the rate changes evenly from one value to another.
  [[nodiscard]] double after(double g, double from_rate, double to_rate, double time) const {
    return strain_of(after(state_of(g), from_rate, to_rate, time));
  }
  /// The same over a step with a mean rate that follows another step: the rate within the step continues its
  /// change from the last step to this one, but keeps its sign. `last_time` 0: there was no step before.
  [[nodiscard]] State after_step(State state, double mean_rate, double time, double last_rate,
                                 double last_time) const {
    const double trend = last_time > 0 ? (mean_rate - last_rate) * time / (time + last_time) : 0;
    const double at_end =
        std::clamp(mean_rate + trend, std::min(0.0, 2 * mean_rate), std::max(0.0, 2 * mean_rate));
    return after(state, 2 * mean_rate - at_end, at_end, time);
  }
  [[nodiscard]] State after(State state, double from_rate, double to_rate, double time) const {
    if (!(time > 0)) return state;
    const auto rate_at = [&](double t) { return from_rate + (to_rate - from_rate) * (t / time); };
    if (from_rate * to_rate < 0) {
      const double turn = from_rate / (from_rate - to_rate) * time;
      return after(after(state, from_rate, 0, turn), 0, to_rate, time - turn);
    }
    const double direction = from_rate + to_rate;
    if (state.z == 1) state.side = direction < 0 ? -1 : 1;
    const double z = followed(state, from_rate, to_rate, time);
    if (z <= 1 || state.side * direction >= 0) return {std::min(z, 1.0), state.side};
    // g passes 0 within the step.
    const double zero = time_of_turn(state, from_rate, to_rate, time);
    state = {1, -state.side};
    return {std::min(followed(state, rate_at(zero), to_rate, time - zero), 1.0), state.side};
  }

 private:
  static constexpr double max_growth = 600;  // of log z, within the range of a double

  /// Time at which g reaches 0 within a step at the end of which z would exceed 1: Newton's method for log z
  /// inside a bracket, starting from the time at an even rate.
  [[nodiscard]] double time_of_turn(State state, double from_rate, double to_rate, double time) const {
    constexpr int most = 60;
    constexpr double precision = 1e-9;  // share of the step
    const double growth = state.side * (to_rate - from_rate) / time;
    const double from = state.side * from_rate;
    const auto with_even_rate = [&](double mean_rate) {
      const double pull = mean_rate + rate;
      const double lags = portable::log1p(pull * (1 - state.z) / std::abs(mean_rate));
      return pull == 0 ? strain * (1 - state.z) / rate : strain / pull * lags;
    };
    double before = 0, after = time;
    double t = std::min(with_even_rate(from), time);
    t = std::min(with_even_rate(from + growth * t / 2), time);
    for (int i = 0; i < most && after - before > precision * time; ++i) {
      const double rate_there = from + growth * t;
      const double z = followed(state, from_rate, state.side * rate_there, t);
      (z > 1 ? after : before) = t;
      const double step = strain * portable::log(z) / (rate_there + rate * (1 - 1 / z));
      const double next = t + step;
      const double missed = (rate + std::abs(growth / rate_there)) / strain * step * step;
      // Near overflow the slope is meaningless.
      if (next >= before && next <= after && z < portable::exp(max_growth / 2)) {
        if (missed <= precision * time) return next;
        t = next;
      } else {
        t = before + (after - before) / 2;
      }
    }
    return after;
  }
  /// z by dz/dt = (u0 - pull z) / c with pull = side rate + u0; above 1 once g has passed 0.
  [[nodiscard]] double followed(State state, double from_rate, double to_rate, double time) const {
    const double from = state.side * from_rate + rate;
    const double to = state.side * to_rate + rate;
    if (from * to >= 0) return followed(state.z, from, to, time);
    const double share = from / (from - to);
    return followed(followed(state.z, from, 0, share * time), 0, to, (1 - share) * time);
  }
  /// The same for pulls of one sign.
  [[nodiscard]] double followed(double z, double from, double to, double time) const {
    const double lags = (from + to) / 2 * time / strain;
    const double growth = (to - from) * (strain / time);
    // What z was before is below rounding then; that of a column at rest is far above the steady one.
    if (lags > (z * to < 10 * rate ? 36 : 60)) return steady(to, growth, 1);
    const double left = portable::exp(std::min(-lags, max_growth));
    if (std::abs(lags) < 1e-3)
      return z * left +
             rate * time / strain * (1 - lags / 2 + lags * lags / 6 - (to - from) * time / strain / 12);
    const double sign = lags < 0 ? -1 : 1;
    return steady(to, growth, sign) + (z - steady(from, growth, sign)) * left;
  }
  /// The solution z of that equation that follows the pull where it changes little within the lag; the pull
  /// changes at the rate growth / c. `sign`: sign of all pulls of a step.
  [[nodiscard]] double steady(double pull, double growth, double sign) const {
    constexpr double little = 0.01;
    if (std::abs(growth) <= little * pull * pull) {
      // u0 / pull int exp(-y + x y^2 / 2) dy over y > 0
      const double x = growth / (pull * pull);
      return rate / pull * (1 + x * (1 + x * (3 + x * (15 + x * 105))));
    }
    const double unit = sign * std::sqrt(2 * std::abs(growth));
    const double x = pull / unit;
    if (growth > 0) return 2 * rate / unit * dawson(x);
    return rate / (unit * std::numbers::inv_sqrtpi) * portable::scaled_erfc(x);
  }
  /// exp(-x^2) int exp(y^2) dy from 0 to x >= 0, to 2e-7: Rybicki's sum over odd multiples of h.
  [[nodiscard]] static double dawson(double x) {
    constexpr double h = 0.4;
    constexpr std::array weights{0.85214378896621135,    0.23692775868212165,    0.018315638888734179,
                                 0.00039366904065507759, 2.3525752000097709e-06, 3.90893843426485e-09};
    const double even = 2 * std::floor(x / (2 * h) + 0.5);
    const double off = x - even * h;
    double power = portable::exp(2 * off * h);
    const double square = power * power;
    double sum = 0;
    double odd = 1;
    for (const double weight : weights) {
      sum += weight * (power * power * (even - odd) + even + odd) / ((even * even - odd * odd) * power);
      power *= square;
      odd += 2;
    }
    return std::numbers::inv_sqrtpi * portable::exp(-off * off) * sum;
  }
};

}  // namespace dashpad
