#pragma once
/// The slip rate u of a foam, which follows the strain rate within a small strain.
///
///   dg/dt = rate - u,   u = u0 (exp(|g| / c) - 1) sgn g                          (theory.md, Eq. 34)
///
/// g is the elastic strain of the rate's stress, the same for all columns below a nose. c is a twentieth of
/// the lag strain, u0 a thousandth of the slowest tested rate. At a constant rate the equation is linear in
/// exp(-|g| / c), and its solution exact. Rates in 1/s.

#include <algorithm>
#include <cmath>

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
    return {std::exp(-std::abs(g) / strain), g < 0 ? -1.0 : 1.0};
  }
  [[nodiscard]] double strain_of(State state) const { return -state.side * strain * std::log(state.z); }

  /// u.
  [[nodiscard]] double slip_rate(double g) const {
    return std::copysign(rate * std::expm1(std::abs(g) / strain), g);
  }
  [[nodiscard]] double slip_rate(State state) const { return state.side * rate * (1 - state.z) / state.z; }

  /// g after a time at a constant strain rate.
  [[nodiscard]] double after(double g, double strain_rate, double time) const {
    State state = state_of(g);
    advance(state, strain_rate, time);
    return strain_of(state);
  }
  /// The same while the rate goes evenly from one value to another.
  [[nodiscard]] double after(double g, double from_rate, double to_rate, double time) const {
    return strain_of(after(state_of(g), from_rate, to_rate, time));
  }
  /// The same over a step of a mean rate, after one of another: the rate within the step goes on as from the
  /// last step to this one, but keeps its sign. `last_time` 0: there was no step before.
  [[nodiscard]] State after_step(State state, double mean_rate, double time, double last_rate,
                                 double last_time) const {
    const double trend = last_time > 0 ? (mean_rate - last_rate) * time / (time + last_time) : 0;
    const double at_end =
        std::clamp(mean_rate + trend, std::min(0.0, 2 * mean_rate), std::max(0.0, 2 * mean_rate));
    return after(state, 2 * mean_rate - at_end, at_end, time);
  }
  [[nodiscard]] State after(State state, double from_rate, double to_rate, double time) const {
    if (state.z == 1) state.side = from_rate < 0 ? -1 : 1;
    const double from = state.side * from_rate + rate;
    const double to = state.side * to_rate + rate;
    const double change = strain * (to - from) / time;
    constexpr double most = 0.01;
    if (std::min(from, to) >= rate && std::abs(change) <= most * std::min(from * from, to * to)) {
      const double z = following(to, change) +
                       (state.z - following(from, change)) * std::exp(-(from + to) / 2 * time / strain);
      return {std::min(z, 1.0), state.side};
    }
    return after_parts(state, from_rate, to_rate, time);
  }

 private:
  /// Where the pull changes little while z follows it, z is a series in that change, but for what it was
  /// before, which dies away: z = u0 / pull int exp(-y + x y^2 / 2) dy over y > 0.
  [[nodiscard]] double following(double pull, double change) const {
    const double x = change / (pull * pull);
    return rate / pull * (1 + x * (1 + x * (3 + x * (15 + x * 105))));
  }
  /// In parts of a constant rate. In a time that is long against the lag the last ones are short, so that g
  /// follows the rate to its end.
  [[nodiscard]] State after_parts(State state, double from_rate, double to_rate, double time) const {
    const double change = (to_rate - from_rate) / 2;
    const double shortest = 0.25 * strain / (std::abs(from_rate) + std::abs(to_rate) + rate);
    double left = time;
    while (left > shortest && left > time / 512) {
      advance(state, from_rate + change * left / 2 / time, left / 2);
      left /= 2;
      from_rate += change * 2 * left / time;
    }
    advance(state, (from_rate + to_rate) / 2, left);
    return state;
  }

  /// dz/dt = (u0 - pull z) / c with pull = side rate + u0.
  void advance(State& state, double strain_rate, double time) const {
    if (state.side * strain_rate < 0) {
      const double crossing = time_to_zero(state.z, state.side * strain_rate + rate);
      if (crossing < time) {
        time -= crossing;
        state = {1, -state.side};
      }
    }
    const double pull = state.side * strain_rate + rate;
    const double exponent = pull * time / strain;
    state.z = std::abs(exponent) < 1e-8 ? state.z + (rate - pull * state.z) * time / strain
                                        : rate / pull + (state.z - rate / pull) * std::exp(-exponent);
    state.z = state.z < 1 ? state.z : 1;
  }
  /// From z to 1, for a pull below u0.
  [[nodiscard]] double time_to_zero(double z, double pull) const {
    if (std::abs(pull) < 1e-9 * rate) return (1 - z) * strain / rate;
    return strain / pull * std::log((pull * z - rate) / (pull - rate));
  }
};

}  // namespace dashpad
