#pragma once
/// The help of neighbours to the columns of a case: the factor of its force, and its limits.

#include <optional>
#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "model/contact/with_neighbours.hpp"

namespace dashpad {

/// Shape of the nose where it first meets the pad.
struct Tip {
  double over_pad = 0;  ///< tip radius over L; of a flat tip, 2 area / perimeter over L
  bool is_flat = false;
  /// Penetration at which a round tip ends, m; infinite if it has no end.
  double until = 0;
};

/// The tip of a nose. Nothing where all columns are loaded alike (a block below a nose as wide) or it was not
/// computed: below cones, cylinders, profiles, long ellipsoids, and if the nose reaches the rim of a block.
std::optional<Tip> tip_of(const ImpactCase& impact);

/// Whether the face of the nose covers the pad, so that all columns are pressed alike.
bool covers_pad(const ImpactCase& impact);

/// g of theory.md, Eq. 57; 1 where there is no tip, and where `pad.neighbours` is 0.
///
///   round, of the radius R   g = 1 + c (L - Y) / R,   frictionless floor: - 0.375 c (Y / L)^2
///   flat, of the radius a    g = 1 + 0.625 c L / a
ColumnFactor factor_of_columns(const ImpactCase& impact);

}  // namespace dashpad
