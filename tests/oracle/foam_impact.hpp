#pragma once
/// A foam by curves in the CVODE oracle.
///
///   dX/dt = V,  M dV/dt = -F,  dp/dt = u(Y / L - p):  p is the strain that has slipped, Y / L - p the
///   elastic one
///
/// F is a function of Y, of its largest value so far and of the elastic strain; so Y is the root of
/// F = Fs(X - Y), taken anew at each call, and three unknowns do. On a support that is damped or carries a
/// panel
///
///   c dx/dt = F - Fs(x),  or  m d2(x + xb)/dt2 = F - T,  T = Fs(x) + c dx/dt,  Mb d2xb/dt2 = T,  Y = X - x -
///   xb
///
/// where Fs of a crushed support comes back along its own slope. The contact integral is over depths even in
/// the root of the strain, by Gauss between the places where the stress changes its sign. Stiff: BDF.
///
/// A pad that was struck before begins as one that comes back from its largest penetration, with nothing
/// slipped where the nose meets it. In a crater X and Y count from the surface of the new pad, and the rate
/// multiplies what is left of a column's stress.

#include "dashpad/model/nose/nose.hpp"
#include "oracle/foam_formulas.hpp"
#include "oracle/impact_run.hpp"

namespace dashpad::oracle {

/// Whole impact of a sphere or a flat disc.
void solve_foam(ImpactRun& run, const FoamFormulas& law, const Nose& nose);

}  // namespace dashpad::oracle
