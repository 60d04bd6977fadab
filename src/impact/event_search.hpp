#pragma once
/// Location of an event in a step by the Illinois rule; values may jump to a bound where no step exists.

#include <algorithm>
#include <cmath>
#include <utility>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {

struct EventSearch {
  double step = 0;              ///< step after which the event has happened, s
  double precision = 0;         ///< precision of the result, s
  double value_now = infinite;  ///< > 0
  double value_then = 0;        ///< at `step`, <= 0; -infinite where that step has no solution
  double guess = infinite;      ///< expected place, if that step has no solution, s
};

/// Two steps: one before the event, where value_at(step) > 0 or the step is 0, and one after it.
template <class Value>
std::pair<double, double> bracket_event(Value&& value_at, const EventSearch& search) {
  constexpr double largest = 1e300;  // largest value to interpolate with
  double low = 0;
  double high = search.step;
  double f_low = search.value_now;
  double f_high = search.value_then;
  int side = 0;
  double before = high;
  for (int i = 0; i < 80 && high - low > search.precision; ++i) {
    const bool is_nowhere = f_high == -infinite;
    double x = is_nowhere ? low : (f_low * high - f_high * low) / (f_low - f_high);
    // Once the guesses have settled, one just beyond the event closes the bracket.
    if (std::abs(x - before) < search.precision / 50) x += (side == 1 ? 1.0 : -1.0) * search.precision / 25;
    before = x;
    // Without a solution at the far end interpolation is impossible: first the guess, then bisection.
    if (is_nowhere) x = i == 0 ? search.guess : infinite;
    if (!(x > low && x < high) || i % 8 == 7) x = low + (high - low) / 2;
    const double f = std::min(value_at(x), largest);
    if (f > 0) {
      low = x, f_low = f;
      if (side == 1) f_high /= 2;
      side = 1;
    } else {
      high = x, f_high = f;
      if (side == -1) f_low /= 2;
      side = -1;
      if (f == 0) break;
    }
  }
  return {low, high};
}

}  // namespace dashpad
