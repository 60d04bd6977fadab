#pragma once
/// The defects of the listing of 1984, each a switch. docs/spit1984.md shows what each does to the results.

#include <array>

namespace dashpad::spit1984 {

/// True: as printed, which is the faithful mode. False: mended.
struct Defects {
  /// A trial that does not widen the contact keeps the bookkeeping of an earlier trial (LAST, RL), and a
  /// later restore puts that back. Mended: every trial starts from the contact at the start of the step.
  bool stale_contact = true;
  /// The later segments of a piecewise-linear support are added where `1 - X(j)/XS > 1`, which compression
  /// never meets: the first slope acts alone. Mended: the secant of the curve, F(XS)/XS.
  bool idle_segments = true;
  /// The strain of the station on the contact edge is what rounding leaves of zero, and a power of it enters
  /// the stress one step later. Mended: it is zero.
  bool edge_residue = true;
  /// The check for tension starts at the outermost station and ends at the first that is not tensile. Laws 4
  /// and 5 set the outermost stress to zero, so it ends there and the rim of the contact pulls on the sphere.
  /// Mended: a tensile stress is zero.
  bool tension = true;

  friend bool operator==(const Defects&, const Defects&) = default;
};

inline constexpr Defects all_mended{false, false, false, false};

/// For people: the name on the command line and one line of explanation.
struct Defect {
  const char* name;
  bool Defects::*present;
  const char* meaning;
};

inline constexpr std::array<Defect, 4> defects{{
    {"stale-contact", &Defects::stale_contact,
     "a rejected trial restores the contact of an earlier one, not that of the step's start"},
    {"idle-segments", &Defects::idle_segments,
     "only the first slope of a piecewise-linear support ever acts"},
    {"edge-residue", &Defects::edge_residue,
     "the strain on the contact edge is rounding error instead of zero"},
    {"tension", &Defects::tension,
     "the rim of the contact pulls on the sphere during rebound (laws 4 and 5)"},
}};

}  // namespace dashpad::spit1984
