#pragma once
/// One impact: what strikes what, how fast. SI throughout.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/model/nose/nose.hpp"
#include "dashpad/model/pad/stress_scale.hpp"
#include "dashpad/model/support/backing.hpp"
#include "dashpad/model/support/support.hpp"

namespace dashpad {

/// A rigid body that moves along one line.
struct Impactor {
  double mass = 0;   ///< kg, > 0
  Nose nose = {};    ///< the part of it that meets the pad
  double speed = 0;  ///< m/s at first contact, towards the pad, > 0
  /// m/s2 along the motion, >= 0. 0: the weight does no work.
  double gravity = 0;
};

/// One layer of a pad, as wide as the pad.
struct PadLayer {
  double thickness = 0;  ///< m, > 0
  Material material;
  PadCondition condition = {};
};

/// What the back of a pad lies on, where that is told to slip or not.
enum class Floor {
  bonded,        ///< it does not slip
  resting,       ///< it does not slip, and may lift off
  frictionless,  ///< it slips
};
inline constexpr std::array floors{Floor::bonded, Floor::resting, Floor::frictionless};
/// "bonded", "resting", "frictionless".
std::string name_of(Floor floor);
/// Nothing for another name.
std::optional<Floor> floor_named(std::string_view name);

struct Pad {
  double thickness = 0;  ///< m, > 0; of a pad of layers, their sum (set_layers)
  Material material;     ///< of a pad of layers, none
  PadCondition condition = {};
  /// Of its face, m2, > 0: a block that may end before the nose does. Without it the pad is wider than the
  /// nose.
  std::optional<double> area = {};
  /// Largest penetration that earlier blows of the same nose at the same place have left in the pad, m, in
  /// [0, thickness): 0 for a new pad, and for laws that recover fully (theory.md, Eq. 61).
  double earlier_penetration = 0;
  /// Mass per area of a sheet on the struck face, kg/m2, 0 (none) or in [1e-3, 1e3]; it has no stiffness
  /// (theory.md, Eq. 76).
  double sheet = 0;
  Floor floor = Floor::bonded;
  /// By how much the columns of the pad are helped by their neighbours, c of Eq. 79 (theory.md), in [0, 2];
  /// 0: not at all, as in the report.
  double neighbours = 0;
  /// From the struck face on; none: the pad is of one foam, `material` under `condition`.
  std::vector<PadLayer> layers = {};
};

/// The same blow again and again, with rests between.
struct Blows {
  int count = 2;  ///< in [2, 100]
  /// Share of the pad's memory that is gone after each rest, in [0, 1]; 0 for foams that stay crushed.
  double recovery = 0;
};

/// What `neighbours` is where nobody says it: 0.8 for the laws of foams, 0 for those of the report and where
/// the numbers of a layer come from strikes by a sphere, in which what neighbours do is.
double nominal_neighbours(const Pad& pad);

/// Gives the pad these layers, and their thickness.
void set_layers(Pad& pad, std::vector<PadLayer> layers);

struct ImpactCase {
  std::string title;
  Impactor impactor;
  Pad pad;
  Support support;
  Backing backing = {};
  std::optional<Blows> blows = {};  ///< none: one blow
};

/// The nose as this pad meets it: no wider than the face of the pad (theory.md, Eq. 3).
Sections sections_of(const ImpactCase& impact);

/// Every physical rule that the case breaks; empty for a case that can be solved. Keys are those of case
/// files, such as `impactor.mass` and `pad.parameters.modulus`.
std::vector<Violation> violations(const ImpactCase& impact);
/// The same but for the law of the pad, where that is known to keep its rules.
std::vector<Violation> violations_beside_law(const ImpactCase& impact);

}  // namespace dashpad
