#pragma once
/// The points of a deck's curve that a card can have.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/model/pad/foam/table_curve.hpp"
#include "input/material_deck/deck_foam.hpp"

namespace dashpad::input {

/// What a curve is for: the base curve must rise, a way back may carry nothing at first.
enum class CurveRole { base, rate, unloading };

struct CleanCurve {
  TableCurve table;
  std::vector<std::size_t> lines;        ///< of each point
  std::optional<double> stress_at_zero;  ///< where the deck has a point there that is not 0
};

/// Without what lies at strain 0 and below it; adds to `differences` what was left out. Faults: strains that
/// do not increase or reach 1, stresses that are not positive or do not rise. Absent after one.
std::optional<CleanCurve> clean_curve(const DeckCurve& curve, CurveRole role, MeasurementFaults& faults,
                                      std::vector<std::string>& differences);

/// The stress of a crushed foam that cannot rise faster than along its modulus: points above that line give
/// way to it. Tells `differences`. False after a fault.
bool limit_to_elastic_line(CleanCurve& curve, double modulus, const DeckCurve& of, MeasurementFaults& faults,
                           std::vector<std::string>& differences);

/// Adds the air to each point. False after a fault.
bool add_air(CleanCurve& curve, const DeckAir& air, const DeckCurve& of, MeasurementFaults& faults);

}  // namespace dashpad::input
