#pragma once
/// The impact solver: one impact, the blows of a series, or many impacts one after the other.

#include <functional>
#include <memory>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Solves one impact (theory.md, section 4): the motion of the impactor, M d2X/dt2 = M g - F, with the force
/// F of the pad in equilibrium with what carries it (theory.md, Eqs. 4, 41 and 42), at successively halved
/// resolutions (two at least) until the estimated errors are within the tolerance. For repeated blows
/// (ImpactCase::blows) the solution is that of the last; solve_blows() returns all. Never throws for a valid
/// case: numerical failures are reported by the status. Throws std::invalid_argument that names every broken
/// rule for a case with violations() or for options out of range.
///
/// Example:
/// \code
/// dashpad::ImpactCase impact;
/// impact.impactor = {.mass = 4.5, .nose = dashpad::Sphere{0.08}, .speed = 5};  // kg, m, m/s
/// impact.pad.thickness = 0.05;                                                 // m
/// impact.pad.material.name = dashpad::foam_of_the_case;
/// impact.pad.material.law = dashpad::Elastic{.modulus = 5e5};  // Pa
/// const dashpad::Summary summary = dashpad::solve(impact).summary;
/// if (summary.trustworthy() && summary.peak_force) std::printf("%.0f N\n", *summary.peak_force);
/// \endcode
Solution solve(const ImpactCase& impact, const Options& options = {});

struct Blow {
  ImpactCase impact;  ///< one blow on the pad as left by the earlier ones
  Solution solution;
};

/// Repeated blows on one pad (theory.md, Eqs. 46 to 48): the same nose, mass and speed at the same place,
/// with rests in between that outlast every relaxation of the pad. Returns the blows of ImpactCase::blows in
/// order, or a single one without them. The series ends early after a blow that leaves the pad in an unknown
/// state (leaves_a_known_pad() of dashpad/impact/flags.hpp). Throws as solve() does.
std::vector<Blow> solve_blows(const ImpactCase& impact, const Options& options = {});

/// A solver for many impacts, which allocates its memory once. Each thread needs its own.
///
/// Example:
/// \code
/// dashpad::Solver solver;
/// for (const double speed : {3.0, 4.0, 5.0}) {  // m/s
///   impact.impactor.speed = speed;
///   std::printf("%.1f mm\n", 1e3 * solver.solve(impact).summary.peak_penetration);
/// }
/// \endcode
class Solver {
 public:
  Solver();
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  /// Solves one impact as solve() does; the solution stays valid until the next call.
  const Solution& solve(const ImpactCase& impact, const Options& options = {});

  /// Called with the case of each blow, with the pad as it meets it, and its solution.
  using BlowVisitor = std::function<void(const ImpactCase&, const Solution&)>;
  /// Solves the blows of a series, or the only one, as solve_blows().
  void solve_each_blow(const ImpactCase& impact, const Options& options, const BlowVisitor& visit);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace dashpad
