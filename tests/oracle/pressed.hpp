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
/// complement, Pa; `corner`: a strain at which its slope jumps, or 1; `rises`: it is nowhere negative.
template <class Stress>
Pressed pressed_by(const Outline& nose, double y, double thickness, double corner, bool rises, bool with_area,
                   const Stress& stress) {
  constexpr int looks = 96;   // where the sign of the stress is asked
  constexpr int panels = 16;  // of the whole contact
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
  if (corner < top) corners.push_back(std::sqrt(corner / top));
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
  const double first = low + 1e-6 * (1 - low);
  double before = first, begin = low;
  bool pressed = at(first) > 0;
  all.most = std::fmax(all.most, at(first));
  for (int i = 1; i <= looks; ++i) {
    const double x = low + (1 - low) * i / looks;
    const double here = at(x);
    all.most = std::fmax(all.most, here);
    if ((here > 0) != pressed) {
      double none = before, other = x;
      for (int k = 0; k < 48; ++k) {
        const double middle = (none + other) / 2;
        ((at(middle) > 0) == pressed ? none : other) = middle;
      }
      if (pressed) add(begin, none);
      begin = other;
      pressed = here > 0;
    }
    before = x;
  }
  if (pressed) add(begin, 1);
  // Crushed foam that is not met carries nothing: its sign has to tell when it is met again.
  if (!(all.most > 0)) all.most = std::fmin(all.most, -1e-3);
  return all;
}

}  // namespace dashpad::oracle
