/// Formulas of foams by curves for single places and batches of nodes, over a number type N.
///
/// Included as text, like src/model/pad/formulas.hpp, where N has + - * /, exp, log, max and pow. SI units.

#define DASHPAD_FOAM_FORMULA [[nodiscard, gnu::always_inline]] inline

/// A cubic over a cell, whose variable goes from 0 to 1.
template <class N>
struct Cubic {
  N a, b, c, d;
};
template <class N>
DASHPAD_FOAM_FORMULA N value_of(const Cubic<N>& given, N t) {
  return given.a + t * (given.b + t * (given.c + t * given.d));
}
/// Work of a stress from the start of a cell to t. `x`: root of the strain there; `h`: width of the cell.
template <class N>
DASHPAD_FOAM_FORMULA N work_of(const Cubic<N>& stress, N x, double h, N t) {
  const auto& [a, b, c, d] = stress;
  constexpr double third = 1.0 / 3;
  const N area = x * (a + t * (b * 0.5 + t * (c * third + t * d * 0.25))) +
                 h * t * (a * 0.5 + t * (b * third + t * (c * 0.25 + t * d * 0.2)));
  return 2 * h * t * area;
}

/// q^-n; the usual exponent 2 needs no logarithm.
template <class N>
DASHPAD_FOAM_FORMULA N inverse_power(const Continuation& beyond, N q) {
  if (beyond.exponent == 2) return 1.0 / (q * q);
  return pow(q, -beyond.exponent);
}
/// Integral of p^-k for p from q to the complement of the last tested strain, given q^-k.
template <class N>
DASHPAD_FOAM_FORMULA N area_of_power(const Continuation& beyond, double k, N q, N power, double last_power) {
  if (k > 1 - 1e-9 && k < 1 + 1e-9) return log(beyond.complement / q);
  return (power * q - last_power * beyond.complement) / (k - 1);
}
/// Work beyond the last tested strain; `power`: q^-n.
template <class N>
DASHPAD_FOAM_FORMULA N work_beyond(const Continuation& beyond, N strain, N q, N power) {
  return beyond.work + (beyond.stress - beyond.growth * beyond.power) * (strain - beyond.strain) +
         beyond.growth * area_of_power(beyond, beyond.exponent, q, power, beyond.power);
}

/// m - 1, and its derivative by ln u (a power) or by the weight of the next tested rate.
template <class N>
struct Over {
  N over;
  N rise;
};
template <class N>
DASHPAD_FOAM_FORMULA Over<N> over_by_power(double exponent, double exponent_slope, double log_rate,
                                           N strain) {
  const N power = max(exponent + exponent_slope * strain, N(0.0));
  const N m = exp(power * log_rate);
  return {m - 1.0, power * m};
}
/// m - 1 from m (linear) or ln m at the tested rates on both sides.
template <class N>
DASHPAD_FOAM_FORMULA Over<N> over_between(bool linear, N before, N next, double weight) {
  // Cubics of curves that touch may cross by rounding; the proof of Eq. 36 needs a stress that does not fall.
  const N low = max(before, N(linear ? 1.0 : 0.0));
  const N step = max(next - low, N(0.0));
  const N between = low + weight * step;
  if (linear) return {between - 1.0, step};
  const N m = exp(between);
  return {m - 1.0, step * m};
}

#undef DASHPAD_FOAM_FORMULA
