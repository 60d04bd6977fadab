#pragma once
/// A second solver of the impact, for verification: the semi-discretised equations in rate form, integrated
/// by SUNDIALS CVODE. It shares nothing with the library's solver but the parameters of the case.
///
///   dX/dt = V,  M dV/dt = -F,  dY/dt = v,  and the stress of every column by its law in rate form,
///   F = Fs(X - Y);  v from d(pad force)/dt = Ks (V - v), one scalar equation a call.
///
/// Loading: columns at fixed shares s/Y of the growing contact (Chebyshev points, spectral), unknown
///   stress/A, which is smooth where the stress itself is not. Starts an instant after contact, Y = 1e-7 L,
///   from the closed form of loading at a constant rate. Stiff: BDF with a dense Jacobian.
/// Unloading: columns at fixed depths s, unknown the stress; it follows its law a little below zero, and only
///   its positive part counts: the ends of that part are found by cubic interpolation. Not stiff: Adams.
/// Turning point: loading ends when the force of holding Y (zero rate) changes at the rate of the support's
///   force, D = Ks V - d(force of holding)/dt = 0. From there v is the negative root of the same equation.
///
/// Laws 1, 2, 4 and 5 of the report, below a sphere, whose penetration must stay below its radius; rigid,
/// linear and piecewise linear supports. Bottoming ends the run. Foams by curves and viscoelastic foams are
/// solved in other forms (foam_impact.hpp, maxwell_impact.hpp), also below a flat disc and beyond the radius;
/// foams by curves also below a cone, a cylinder
/// on its side and a profile by radii.

#include <optional>
#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::oracle {

struct CvodeOptions {
  int loading_columns = 48;     ///< Chebyshev points, >= 8
  int unloading_columns = 320;  ///< >= 8
  double rtol = 1e-9;           ///< relative error a step
  double atol = 1e-2;  ///< absolute error a step over rtol, in units of the natural scale of an unknown
  double axis_grading = 0.02;         ///< share of the depth that is resolved on its own near the axis
  double edge_power = 5;              ///< how strongly the columns cluster towards the edge on loading
  double gravity = standard_gravity;  ///< m/s2, of the "weight" event
};

enum class Ending {
  released,
  bottomed_out,  ///< gap below 1e-7 of the thickness
  reloading,     ///< the turning point rule asks for loading again: not handled
  failed,        ///< CVODE gave up
};

struct CvodeImpact {
  Ending ending = Ending::failed;
  double peak_force = 0;          ///< N
  double time_of_peak_force = 0;  ///< s
  double peak_motion = 0;         ///< m
  double peak_penetration = 0;    ///< m
  double time_of_turning = 0;     ///< s: loading ends
  double turning_speed = 0;       ///< m/s, of penetration just after: the finite jump
  std::optional<Moment> weight;   ///< force below the weight on rebound
  /// Force below a thousandth of its peak, for the last time.
  std::optional<Moment> contact_end;
  std::optional<Moment> release;
  std::optional<Moment> bottomed;
  double energy_absorbed = 0;  ///< 1 - (release speed / impact speed)^2
  double body_velocity = 0;    ///< m/s, of a free body behind the support, at release
  /// Pad force minus support force over the peak force: the drift of the rate form, largest magnitude at the
  /// turning point and at release.
  double drift = 0;
  long derivative_calls = 0;
  long steps = 0;
  double wall_time = 0;  ///< s
};

/// Throws std::invalid_argument for a law or a nose that it does not know, or, but for foams, a pad
/// thicker than the sphere's radius.
CvodeImpact solve_with_cvode(const ImpactCase& impact, const CvodeOptions& options = {});

/// Relative differences (a over b, minus 1) of a Summary from the oracle; absent where one has no such
/// figure.
struct Differences {
  std::optional<double> peak_force, time_of_peak_force, peak_motion, peak_penetration;
  std::optional<double> weight_time, weight_velocity, contact_end_time, contact_end_velocity, release_time,
      release_velocity;
  /// Largest magnitude of those present.
  [[nodiscard]] double largest() const;
  /// One line for a test's message.
  [[nodiscard]] std::string text() const;
};
Differences compare(const Summary& summary, const CvodeImpact& oracle);

}  // namespace dashpad::oracle
