#pragma once
/// Law 1: linear elastic pad.
///
///   G = E e,  h -> infinity (the stress is the envelope)            (theory.md, Eq. 10; report, KEYP = 1)
///
/// Stress and strain are engineering values, compression positive. The law loses no energy.

#include <array>

#include "dashpad/model/pad/stress_curve.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Elastic {
  double modulus = 0;  ///< E, Pa, > 0

  static constexpr const char* name = "elastic";
  static constexpr bool memoryless = true;
  static constexpr bool recovers = true;  ///< unloads along its loading curve
  static const std::array<Parameter<Elastic>, 1> parameters;

  [[nodiscard]] StressCurve curve() const {
    StressCurve curve;
    curve.add_kink(0, modulus);
    return curve;
  }

  friend bool operator==(const Elastic&, const Elastic&) = default;
};

inline constexpr std::array<Parameter<Elastic>, 1> Elastic::parameters{{
    {"modulus", "E", "Pa", &Elastic::modulus, positive, "Young's modulus"},
}};

}  // namespace dashpad
