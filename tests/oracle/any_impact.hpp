#pragma once
/// The general oracle: a second solver of whole impacts over nearly everything that a case may hold, written
/// from theory.md alone (Eqs. 1 to 6, 41 to 43, 46 to 49, 51, 56), on CVODE. Clear rather than fast.
///
///   (M + m) dV/dt = M g - F - D,  F = F(Y, what the pad remembers)
///   massless support:  Y is the root of F(Y) = Fs(X - Y - xb); laws 4 and 5: dY/dt is that of dF/dt = dFs/dt
///   with a damper:     c dx/dt = F - Fs(x),          Y = X - x - xb
///   with a panel:      m d2(x + xb)/dt2 = F - T,     T = Fs(x) + c dx/dt,  Mb d2xb/dt2 = T
///
/// Laws 4 and 5 hardly move on a damper while they turn; from a thousandth of the impact speed on what is
/// integrated is the logarithm of their speed v,
///
///   c dv/dt = c (dV/dt - dvb/dt) + Fs' (V - vb - v) - dF/dt(v)
///
/// or, below 1e-11 of the impact speed, the v at which that is 0; and they turn where it is below 0 at v = 0
/// (Eqs. 26 and 45), to the fastest speed back that there is.
///
/// All noses, areas of the pad, laws, layers, earlier blows, sheets, gravity. Layers on a support without
/// mass and damper lie on a damper of a millionth of its stiffness times thickness over speed. Not covered: a
/// panel under preload on a free body, what comes after a pad is fully compressed, and laws 4 and 5 that load
/// again on a support without mass and damper, or are met again where the nose had left them.

#include <optional>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::oracle {

/// SI; forces are those on the impactor.
struct AnyImpact {
  enum class Ending { released, at_rest, bottomed_out, failed } ending = Ending::failed;
  double peak_force = 0, peak_motion = 0, peak_penetration = 0;
  double peak_transmitted = 0, peak_deflection = 0, set = 0, body_speed = 0;
  double rebound_speed = 0;
  std::optional<Moment> force_below_weight, contact_end, bottomed;
  /// Of a pad that is left: the share of the impact energy that is neither in impactor, support, panel and
  /// body nor lost in the support; and the head injury criterion over 15 and 36 ms.
  std::optional<double> absorbed, hic15, hic36;
  long steps = 0;
};

struct AnyOptions {
  double relative = 1e-9;   ///< error a step
  int fineness = 1;         ///< columns, panels and looks are as many times as many
  double max_seconds = 20;  ///< of the processor, of each of up to two runs
  long max_steps = 30'000;
};

/// One blow. Throws std::invalid_argument for what is not covered.
AnyImpact solve_any(const ImpactCase& impact, const AnyOptions& options = {});

}  // namespace dashpad::oracle
