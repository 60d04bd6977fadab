#pragma once
/// One impact: impactor, pad, support, and the blows of a series. SI throughout.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/model/nose/nose.hpp"
#include "dashpad/model/pad/stress_scale.hpp"
#include "dashpad/model/support/support.hpp"

namespace dashpad {

/// A rigid body that moves along one line.
struct Impactor {
  double mass = 0;   ///< kg, > 0
  Nose nose = {};    ///< part that meets the pad
  double speed = 0;  ///< speed at first contact, towards the pad, m/s, > 0
  /// Gravity along the motion, m/s2, >= 0; with 0 the weight does no work.
  double gravity = 0;

  static const std::array<Parameter<Impactor>, 3> parameters;
};

inline constexpr std::array<Parameter<Impactor>, 3> Impactor::parameters{{
    {"mass", "M", "kg", &Impactor::mass, wide(1e-6, 1e6), "mass of the impactor"},
    {"speed", "V", "m/s", &Impactor::speed, wide(1e-4, 1e3), "impact speed"},
    {"gravity", "g", "m/s2", &Impactor::gravity, from_to(0, 1000), "gravity", LeftOut::as_default},
}};

/// One layer of a pad, as wide as the pad.
struct PadLayer {
  double thickness = 0;  ///< m, > 0
  Material material;
  PadCondition condition = {};

  static const std::array<Parameter<PadLayer>, 1> parameters;
};

/// The least thickness is a share of the pad's (violations()).
inline constexpr std::array<Parameter<PadLayer>, 1> PadLayer::parameters{{
    {"thickness", "L", "m", &PadLayer::thickness, positive, "thickness of the layer"},
}};

/// Floor on which the back of a pad lies.
enum class Floor {
  bonded,        ///< it does not slip
  resting,       ///< it does not slip, and may lift off
  frictionless,  ///< it slips
};
inline constexpr std::array floors{Floor::bonded, Floor::resting, Floor::frictionless};
/// "bonded", "resting", "frictionless".
std::string name_of(Floor floor);
/// The floor with that name; nothing for an unknown name.
std::optional<Floor> floor_named(std::string_view name);

struct Pad {
  double thickness = 0;  ///< m, > 0; with layers their sum (set_layers())
  Material material;     ///< unused with layers
  PadCondition condition = {};
  /// Area of the face of a block, m2, > 0, which the nose may overhang; else the pad is wider than the nose.
  std::optional<double> area = {};
  /// Largest penetration remembered from earlier blows of the same nose at the same place, m, in [0,
  /// thickness); 0 for a new pad and for laws that recover fully (theory.md, Eq. 46).
  double earlier_penetration = 0;
  /// Mass per area of a limp sheet on the struck face, kg/m2, 0 (none) or in [1e-3, 1e3] (theory.md, Eq. 56).
  double sheet = 0;
  Floor floor = Floor::bonded;
  /// Help of the columns by their neighbours, c of theory.md, Eq. 57, in [0, 2]; 0: none, as in the report.
  double neighbours = 0;
  /// Layers from the struck face on; if empty, the pad is of one foam, `material` under `condition`.
  std::vector<PadLayer> layers = {};

  static const std::array<Parameter<Pad>, 5> parameters;
};

inline constexpr std::array<Parameter<Pad>, 5> Pad::parameters{{
    {"thickness", "L", "m", &Pad::thickness, wide(1e-5, 1e2), "thickness of the pad"},
    {"area", "", "m2", &Pad::area, wide(1e-10, 1e4), "area of the pad", LeftOut::as_default},
    {"earlier_penetration", "", "m", &Pad::earlier_penetration, not_negative, "earlier penetration",
     LeftOut::as_default},
    {"sheet_mass_per_area", "", "kg/m2", &Pad::sheet, wide(1e-3, 1e3), "mass per unit area of the sheet",
     LeftOut::none},
    {"neighbours", "c", "1", &Pad::neighbours, in_words(0, 2, "from 0 (isolated columns) to 2"),
     "effect of neighbouring columns", LeftOut::computed, "0.2.0"},
}};

/// A series of equal blows with rests in between.
struct Blows {
  int count = 2;  ///< in [2, 100]
  /// Share of the pad's memory that is lost in each rest, in [0, 1]; 0 for foams that stay crushed.
  double recovery = 0;

  static const std::array<Parameter<Blows>, 2> parameters;
};

inline constexpr std::array<Parameter<Blows>, 2> Blows::parameters{{
    {"count", "", "1", &Blows::count, in_words(2, 100, "from 2 to 100"), "number of blows"},
    {"recovery", "", "1", &Blows::recovery, in_words(0, 1, "from 0 (none) to 1 (full)"),
     "recovery between blows"},
}};

/// Default of `neighbours`: 0.8 for foams by their curves and viscoelastic foam; 0 for the laws of the
/// report, and for cards measured by strikes of a sphere, whose numbers include the help of neighbours. A pad
/// of layers has 0.8 only if all its layers do.
double nominal_neighbours(const Pad& pad);

/// Gives the pad these layers and the sum of their thicknesses.
void set_layers(Pad& pad, std::vector<PadLayer> layers);

struct ImpactCase {
  std::string title;
  Impactor impactor;
  Pad pad;
  Support support;
  Backing backing = {};
  std::optional<Blows> blows = {};  ///< absent: one blow
};

/// Sections of the nose, limited to the face of the pad (theory.md, Eq. 3).
Sections sections_of(const ImpactCase& impact);

/// Every physical rule that the case breaks; empty for a case that can be solved. Keys are those of case
/// files, such as `impactor.mass` and `pad.parameters.modulus`.
std::vector<Violation> violations(const ImpactCase& impact);
/// The same without the rules of the pad's law, for one that is known to keep them.
std::vector<Violation> violations_beside_law(const ImpactCase& impact);

}  // namespace dashpad
