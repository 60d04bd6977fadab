#pragma once
/// Rules of a foam's curves beyond the bounds of single numbers.
///
/// Keys are those of cards: `curve.stress[3]`, `rate.curves[1].strain[2]`, `unloading.stress[4]`.

#include <vector>

#include "dashpad/model/pad/crushable_foam.hpp"
#include "dashpad/model/pad/foam.hpp"

namespace dashpad {

void check_rules(const Foam& law, std::vector<Violation>& broken);
void check_rules(const CrushableFoam& law, std::vector<Violation>& broken);

/// Share of the largest earlier stress by which a curve of a higher rate may fall; results are then flagged.
inline constexpr double max_softening = 0.1;
/// Share by which curves may cross, as an error of plotting or digitising; they are then taken to touch.
inline constexpr double max_crossing = 0.02;

/// The stress at a strain on straight lines from the origin through the points, Pa; constant beyond the last.
double on_straight_lines(const std::vector<double>& strain, const std::vector<double>& stress, double at);

/// Rates of the tests, 1/s, increasing; the first is that of the base curve.
std::vector<double> tested_rates(const FoamCurves& curves);

/// Rates with a curve that falls somewhere by more than a thousandth, 1/s.
std::vector<double> softening_rates(const FoamCurves& curves);

}  // namespace dashpad
