#pragma once
/// The contact integral of the oracle, for pads whose stress is a function of the strain at a moment.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "oracle/gauss.hpp"
#include "oracle/outline.hpp"

namespace dashpad::oracle {

/// What a nose presses on.
struct Pressed {
  double force = 0;  ///< N
  double area = 0;   ///< under stress, m2; only where it is asked for
  /// Largest stress with its sign, Pa: the pad is left where it falls to 0. Above the surface below 0.
  double most = -1;
};

/// Depths are even in the root of the strain: strain = top x^2, s = y (1 - x^2). `stress` of a strain and its
/// complement, Pa; `at_strains`: at which its slope jumps; `rises`: it is nowhere negative.
template <class Stress>
Pressed pressed_by(const Outline& nose, double y, double thickness, const std::vector<double>& at_strains,
                   bool rises, bool with_area, int fineness, const Stress& stress) {
  const int looks = 96 * fineness;   // where the sign of the stress is asked
  const int panels = 16 * fineness;  // of the whole contact
  if (y <= 0) return {0, 0, std::min(y / thickness, -1e-300)};
  const double top = y / thickness;
  const auto at = [&](double x) {
    const double depth = 1 - x * x;
    return stress(top * x * x, (1 - top) + top * depth);
  };
  Pressed all;
  const double on_axis = at(1);
  all.most = on_axis;
  if (nose.tip > 0 && on_axis > 0) all.force = nose.tip * on_axis, all.area = nose.tip;
  if (nose.end == 0) return all;
  const double low = std::sqrt(std::fmax(y - nose.end, 0) / y);
  const auto beside_axis = [&](double rest) {  // x = 1 - rest; a'(s) ds with s = y rest (1 + x)
    const double x = 1 - rest;
    return at(x) * nose.widening(y * rest * (1 + x)) * 2 * x * y;
  };
  const auto integral = [&](double from, double to) {
    const int count = std::max(static_cast<int>(std::ceil(panels * (to - from))), 1);
    if (!nose.is_steep_at_tip || to < 1)
      return gauss(from, to, count, [&](double x) { return beside_axis(1 - x); });
    return gauss(0, 1, count,
                 [&](double v) { return beside_axis((to - from) * v * v) * 2 * (to - from) * v; });
  };
  // Close to full compression the stress changes over the gap that is left on the axis.
  const auto graded = [&](double from, double to) {
    double sum = 0;
    if (to == 1)
      for (; (1 - from) / 2 > (1 - top) / 4 && 1 - from > 1e-8; from = (1 + from) / 2)
        sum += integral(from, (1 + from) / 2);
    return sum + integral(from, to);
  };
  std::vector<double> corners;
  for (const double strain : at_strains)
    if (0 < strain && strain < top) corners.push_back(std::sqrt(strain / top));
  for (const double depth : nose.corners)
    if (depth < y) corners.push_back(std::sqrt(1 - depth / y));
  std::ranges::sort(corners);
  const auto add = [&](double from, double to) {
    if (with_area) all.area += nose.area(y * (1 - from * from)) - nose.area(y * (1 - to * to));
    for (const double place : corners)
      if (from < place && place < to) all.force += graded(from, place), from = place;
    all.force += graded(from, to);
  };
  if (rises) {
    add(low, 1);
    return all;
  }
  // Where the stress is asked for its sign: evenly, and at peaks between two looks of the other sign, as the
  // ring on which alone a crushed foam presses at last.
  std::vector<double> place, value;
  const auto look = [&](double x, double found) { place.push_back(x), value.push_back(found); };
  double before = 0, here = 0;
  for (int i = 0; i <= looks + 1; ++i) {
    const double step = (1 - low) / looks, x = low + step * std::fmax(i, 1e-6);
    const double next = i <= looks ? at(x) : here;
    const double way = here > 0 ? -1 : 1, rise = way * (here - before), fall = way * (here - next);
    if (i > 1 && i <= looks && rise >= 0 && fall >= 0 && std::fabs(here) < rise + fall) {
      double from = x - 2 * step, to = x;
      for (int k = 0; k < 30; ++k) {  // golden section
        const double a = to - 0.618034 * (to - from), b = from + 0.618034 * (to - from);
        (way * at(a) < way * at(b) ? from : to) = way * at(a) < way * at(b) ? a : b;
      }
      const double peak = (from + to) / 2, most = at(peak);
      if (peak < x - step) {
        const double then = place.back();
        place.back() = peak, value.back() = most;
        look(then, here);
      } else {
        look(peak, most);
      }
    }
    if (i <= looks) look(x, next);
    before = here, here = next;
  }
  double begin = low;
  for (std::size_t i = 0; i < place.size(); ++i) {
    all.most = std::fmax(all.most, value[i]);
    if (i == 0 || (value[i] > 0) == (value[i - 1] > 0)) continue;
    double same = place[i - 1], other = place[i];
    for (int k = 0; k < 48; ++k) {
      const double middle = (same + other) / 2;
      ((at(middle) > 0) == (value[i] > 0) ? other : same) = middle;
    }
    if (value[i - 1] > 0) add(begin, same);
    begin = other;
  }
  if (value.back() > 0) add(begin, 1);
  return all;
}

}  // namespace dashpad::oracle
