#pragma once
/// Nodes and weights of an integral over the work of a foam's base curve.
///
///   int f s de = int f dW                                                      (theory.md, Eq. 32)
///
/// in panels of three nodes, through which f is a parabola in W. This integrates the stress itself exactly,
/// with every corner of a tested curve, and leaves only f to be resolved, which is smooth. Panels are even in
/// the root of the strain up to the last tested strain, and in the logarithm of its complement beyond; the
/// middle of a panel lies at its mean strain, or at the mean of that logarithm.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "dashpad/quantities/portable_math.hpp"
#include "model/contact/foam_nodes.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {

/// Weights of three values at distances g and h in W.
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
/// Weights of the line through the last two, since near the contact's edge the value of f tells little.
inline PanelWeights line(double g, double h) {
  const double last = (g + h) * (h - g) / (2 * h);
  return {0, g + h - last, last};
}

/// Range and resolution of an integral.
struct WorkStretch {
  FoamStress::Place first;
  FoamStress::Place end;
  bool from_edge = false;    ///< the range begins at the contact's edge, where f may jump
  double panels_within = 2;  ///< number of panels over tested strains
  double panels_beyond = 1;  ///< number for each factor of e in the complement
};

/// Integrals of the stress and of its relaxing.
class WorkIntegral {
 public:
  double stress = 0;
  double relaxing = 0;
  std::size_t nodes = 0;

  /// Integrates up to the end, where f is 0. `values` is scratch memory: `put` sets the values of a place at
  /// an index, `within` and `beyond` fill in those of a NodeRow. `last`: last tested strain.
  template <class Put, class Within, class Beyond>
  void take(const WorkStretch& over, double last, NodeValues& values, Put&& put, Within&& within,
            Beyond&& beyond) {
    const auto count = [](double wanted, double least) {
      constexpr double max_panels = 2000;
      if (!(wanted > least)) return static_cast<std::size_t>(least);  // NaN of a step tried too long as well
      return static_cast<std::size_t>(std::min(std::ceil(wanted), max_panels));
    };
    at_edge_ = over.from_edge;
    values.work[0] = over.first.base.work;
    if (!at_edge_) put(over.first, values, 0);
    const Strain from = over.first.strain;
    const Strain to = over.end.strain;
    const bool ends_within = to.value <= last;
    if (from.value < last) {
      const double low = std::sqrt(from.value);
      const double range = std::sqrt(std::min(to.value, last)) - low;
      const std::size_t panels = count(over.panels_within, 2);
      add(low, range, panels, ends_within ? &over.end : nullptr, values, within);
    }
    if (ends_within) return;
    const double outer = portable::log(std::min(from.complement, 1 - last));
    const double range = outer - portable::log(to.complement);
    add(outer, range, count(over.panels_beyond * range, 1), &over.end, values, beyond);
  }

 private:
  template <class Fill>
  void add(double from, double range, std::size_t panels, const FoamStress::Place* end, NodeValues& values,
           Fill& fill) {
    NodeRow row{from, range / (2 * static_cast<double>(panels)), 1, 0};
    for (std::size_t left = 2 * panels; left > 0; left -= row.count) {
      row.count = std::min(left, NodeValues::most);
      fill(row, values);
      if (row.count == left && end != nullptr) {
        values.work[left] = end->base.work;
        values.stress[left] = values.relaxing[left] = 0;
      }
      nodes += row.count;
      add_panels(values, row.count);
      row.first += row.count;
    }
  }
  void add_panels(NodeValues& values, std::size_t count) {
    const auto& [work, f, r] = values;
    for (std::size_t i = 0; i < count; i += 2, at_edge_ = false) {
      const double g = work[i + 1] - work[i];
      const double h = work[i + 2] - work[i + 1];
      if (!(g > 0 && h > 0)) continue;
      const PanelWeights panel_weights = at_edge_ ? line(g, h) : parabola(g, h);
      stress += panel_weights.middle * f[i + 1] + panel_weights.last * f[i + 2];
      relaxing += panel_weights.middle * r[i + 1] + panel_weights.last * r[i + 2];
      if (at_edge_) continue;
      stress += panel_weights.first * f[i];
      relaxing += panel_weights.first * r[i];
    }
    for (auto* each : {&values.work, &values.stress, &values.relaxing}) (*each)[0] = (*each)[count];
  }

  bool at_edge_ = false;
};

}  // namespace dashpad
