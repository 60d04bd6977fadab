#pragma once
/// What a support has beside its curve Fs: what it loses, what of it moves, and how it is fitted.
///
///   T = Fs(x) + c dx/dt     on the body behind or the ground                    (theory.md, Eq. 41)
///   m d2xp/dt2 = F - T,     Mb d2xb/dt2 = T,     x = xp - xb                     (theory.md, Eq. 42)
///
/// xp is the motion of the panel that carries the pad, xb that of a body which was free and at rest; F is
/// the force of the pad. All positive in compression, from rest at first contact; SI units. A number that is
/// 0 is not there: the support as the report has it.

#include <array>

#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Backing {
  double unloading_stiffness = 0;  ///< N/m, by which a support that was crushed comes back; 0: it is elastic
  double damping = 0;              ///< c, N s/m
  double loss_factor = 0;          ///< eta of the same damper: c = eta sqrt(k (M + m)), k the first slope
  double mass = 0;                 ///< m, kg, of the panel
  double body_mass = 0;            ///< Mb, kg; 0: the ground
  double gap = 0;                  ///< m, which the panel goes before it meets the support
  double preload = 0;              ///< N, with which the support holds the panel against a stop
  double earlier_force = 0;        ///< N, the largest that a support which crushes has carried before

  static const std::array<Parameter<Backing>, 8> parameters;

  friend bool operator==(const Backing&, const Backing&) = default;
};

inline constexpr std::array<Parameter<Backing>, 8> Backing::parameters{{
    {"unloading_stiffness", "k_u", "N/m", &Backing::unloading_stiffness, wide(1e-3, 1e15),
     "slope on which a crushed support comes back", LeftOut::none},
    {"damping", "c", "N s/m", &Backing::damping, wide(1e-6, 1e12), "damping of a damper beside the support",
     LeftOut::none},
    {"loss_factor",
     "\\eta",
     "1",
     &Backing::loss_factor,
     {0, 2, true, true},
     "loss factor of the support, as a damper",
     LeftOut::none},
    {"mass", "m", "kg", &Backing::mass, wide(1e-6, 1e6), "mass of the panel that carries the pad",
     LeftOut::none},
    {"body_mass", "M_b", "kg", &Backing::body_mass, wide(1e-6, 1e6), "mass of a free body behind the support",
     LeftOut::none},
    {"gap", "x_g", "m", &Backing::gap, wide(1e-5, 1e2), "gap between panel and support", LeftOut::none},
    {"preload", "F_p", "N", &Backing::preload, wide(1e-6, 1e12),
     "force of the support at rest, against a stop", LeftOut::none},
    {"earlier_force", "F_e", "N", &Backing::earlier_force, wide(1e-6, 1e12),
     "largest force of the support before, if it crushes", LeftOut::none},
}};

}  // namespace dashpad
