#pragma once
/// Law 3: rigid foam that crushes and does not recover.
///
///   loading:   G = S1 up to e1, then straight to (e2, S2), then with slope 9 S2 / (1 - e2); h -> infinity
///   unloading: rigid; the pad holds its deformation while the support unloads it, 0 <= stress <= G
///                                                                (theory.md, Eq. 12; report, KEYP = 3)
///
/// Stress and strain are engineering values, compression positive.

#include <array>

#include "dashpad/model/pad/stress_curve.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct RigidFoam {
  double crush_stress = 0;   ///< S1, Pa, > 0
  double crush_strain = 0;   ///< e1, strain at the end of the plateau, in (0, 1), below second_strain
  double second_stress = 0;  ///< S2, Pa, >= S1
  double second_strain = 0;  ///< e2, in (0, 1)

  static constexpr const char* name = "rigid-foam";
  static constexpr bool memoryless = true;
  static constexpr bool recovers = false;
  static const std::array<Parameter<RigidFoam>, 4> parameters;

  [[nodiscard]] StressCurve curve() const {
    const double slope = (second_stress - crush_stress) / (second_strain - crush_strain);
    StressCurve curve;
    curve.initial_stress = crush_stress;
    curve.add_kink(crush_strain, slope);
    curve.add_kink(second_strain, 9 * second_stress / (1 - second_strain) - slope);
    return curve;
  }
};

inline constexpr std::array<Parameter<RigidFoam>, 4> RigidFoam::parameters{{
    {"crush_stress", "S1", "Pa", &RigidFoam::crush_stress, positive, "stress of the crush plateau"},
    {"crush_strain", "e1", "1", &RigidFoam::crush_strain, Bounds{.lowest = 0, .highest = 1},
     "strain at the end of the plateau, less than second_strain"},
    {"second_stress", "S2", "Pa", &RigidFoam::second_stress, positive,
     "stress at second_strain, at least crush_stress"},
    {"second_strain", "e2", "1", &RigidFoam::second_strain, Bounds{.lowest = 0, .highest = 1},
     "strain at which the last, steepest part begins"},
}};

}  // namespace dashpad
