#pragma once
/// Nodes and weights of an integral over the work of a foam's base curve.
///
///   int f s de = int f dW                                                      (theory.md, Eq. 32)
///
/// in panels of three nodes, through which f is a parabola in W. The stress itself, with every corner of a
/// tested curve, is thereby integrated exactly; what is left to be resolved is f, which is smooth. Panels are
/// even in the root of the strain up to the last tested strain, even in the logarithm of its complement
/// beyond.

#include <algorithm>
#include <cmath>

#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {

/// Weights of three values over the stretches g and h between them.
struct PanelWeights {
  double first = 0;
  double middle = 0;
  double last = 0;
};
inline PanelWeights parabola(double g, double h) {
  const double first = (2 * g - h) * (g + h) / (6 * g);
  const double last = (2 * h - g) * (g + h) / (6 * h);
  return {first, g + h - first - last, last};
}
/// Of the line through the last two: near the contact's edge f may change within far less than a panel, so
/// that its value there stands for nothing.
inline PanelWeights line(double g, double h) {
  const double last = (g + h) * (h - g) / (2 * h);
  return {0, g + h - last, last};
}

/// Calls visit(place, weight in J/m3) for every node from one place to another but the last, where f is
/// nothing. `panels`: over the whole range of the root of the strain, and over a factor of e in its
/// complement. `from_edge`: f may jump at the first place.
template <class Visit>
void visit_work_nodes(const FoamStress& stress, const FoamStress::Place& first, const FoamStress::Place& end,
                      double panels_of_contact, double panels_beyond, bool from_edge, Visit&& visit) {
  const auto count = [](double wanted, double least) {
    constexpr double most_panels = 2000;
    return std::clamp(std::ceil(wanted), least, most_panels);
  };
  FoamStress::Place before = first;
  double weight = 0;  // of `before`, from the panel that ends there
  bool at_edge = from_edge;
  const auto add = [&](const FoamStress::Place& middle, const FoamStress::Place& now) {
    const double g = middle.base.work - before.base.work;
    const double h = now.base.work - middle.base.work;
    const PanelWeights of = !(g > 0 && h > 0) ? PanelWeights{} : at_edge ? line(g, h) : parabola(g, h);
    if (!at_edge) visit(before, weight + of.first);
    visit(middle, of.middle);
    weight = of.last;
    before = now;
    at_edge = false;
  };
  const FoamCurve& curve = stress.curve();
  const double last = curve.last_strain();
  if (first.strain.value < last) {
    const bool ends = end.strain.value <= last;
    const double low = std::sqrt(first.strain.value);
    const double high = std::sqrt(std::min(end.strain.value, last));
    const double panels = count(panels_of_contact, 2);
    for (double i = 1, z = low; i <= panels; ++i) {
      const double next = i == panels ? high : low + (high - low) * i / panels;
      const FoamStress::Place middle = stress.within(std::sqrt((z * z + next * next) / 2));
      add(middle, i == panels && ends ? end : stress.within(next));
      z = next;
    }
  }
  if (end.strain.value > last) {
    const double outer = std::min(first.strain.complement, 1 - last);
    const double range = std::log(outer / end.strain.complement);
    const double panels = count(panels_beyond * range, 1);
    const double half = std::exp(-range / (2 * panels));
    const double growth = curve.inverse_power(half);
    double q = outer;
    double power = curve.inverse_power(outer);
    for (double i = 1; i <= panels; ++i) {
      const double middle = q * half;
      q = middle * half;
      const FoamStress::Place at_middle = stress.beyond({1 - middle, middle}, power * growth);
      power *= growth * growth;
      add(at_middle, i == panels ? end : stress.beyond({1 - q, q}, power));
    }
  }
}

}  // namespace dashpad
