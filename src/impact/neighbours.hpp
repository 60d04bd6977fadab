#pragma once
/// By how much neighbours help the columns of a case: the factor of its force, and where it stops.

#include <optional>
#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "model/contact/with_neighbours.hpp"

namespace dashpad {

/// Of the nose where it first meets the pad.
struct Tip {
  double over_pad = 0;  ///< radius of its round tip, or of a disc with the perimeter of its flat one, over L
  bool is_flat = false;
  /// Penetration at which a round tip ends, m; infinite where the nose goes on as it begins.
  double until = 0;
};

/// Nothing where columns have no neighbours that they do not share the load with (a block below a nose that
/// is as wide), and where what they do was not computed: below cones, cylinders, profiles, ellipsoids that
/// are long, and on a block whose rim the nose reaches.
std::optional<Tip> tip_of(const ImpactCase& impact);

/// Whether the face of the nose covers the pad, so that all columns are pressed alike.
bool covers_pad(const ImpactCase& impact);

/// g of theory.md, Eq. 57; 1 where there is no tip, and where `pad.neighbours` is 0.
///
///   round, of the radius R   g = 1 + c (L - Y) / R,   frictionless floor: - 0.375 c (Y / L)^2
///   flat, of the radius a    g = 1 + 0.625 c L / a
ColumnFactor factor_of_columns(const ImpactCase& impact);

}  // namespace dashpad
