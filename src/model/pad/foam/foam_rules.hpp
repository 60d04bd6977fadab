#pragma once
/// What the curves of a foam must keep to beyond the bounds of single numbers.
///
/// Keys are those of cards: `curve.stress[3]`, `rate.curves[1].strain[2]`, `unloading.stress[4]`.

#include <vector>

#include "dashpad/model/pad/crushable_foam.hpp"
#include "dashpad/model/pad/foam.hpp"

namespace dashpad {

void check_rules(const Foam& law, std::vector<Violation>& broken);
void check_rules(const CrushableFoam& law, std::vector<Violation>& broken);

/// A curve of a higher rate may fall by this share of the largest stress before; then the result is flagged.
inline constexpr double most_softening = 0.1;
/// Curves that cross by less are taken to touch: what a plotter or a digitiser leaves.
inline constexpr double most_crossing = 0.02;

/// The rates, 1/s, whose curves fall somewhere by more than a thousandth.
std::vector<double> softening_rates(const FoamCurves& curves);

}  // namespace dashpad
