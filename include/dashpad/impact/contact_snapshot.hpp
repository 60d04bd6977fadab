#pragma once
/// Strain and stress under the nose at chosen moments of a solved impact.
///
/// The solver keeps no columns. They are computed again by leading the penetration of the history through the
/// pad's law, with stations of their own. The trapezoidal integral of the stress as it is returned differs
/// from the force of the history by less than 1 % (tests/verification/test_contact_snapshot.cpp).

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

struct ContactSnapshot {
  double time = 0;   ///< s
  double force = 0;  ///< force of the pad's columns, N
  std::string when;  ///< "loading", "peak force", "unloading"
  /// False where the law does not determine the distribution of the force: in a locked pad the stress is that
  /// of the foam before the lock, in rigid foam while it is held the crush stress is scaled to the force.
  bool determined = true;
  std::vector<double> radius;  ///< m, from the axis to the edge of the contact, increasing
  std::vector<double> strain;
  std::vector<double> stress;  ///< Pa, >= 0

  /// Integral of the stress over the contact, N.
  [[nodiscard]] double force_of_stress() const;
};

/// Snapshots at a quarter, a half and the whole of the time to the largest force, then halfway and nine
/// tenths of the way from there to the end, each at the nearest entry of the history and only once. Where the
/// force is largest at the end: at a quarter, a half, three quarters and the whole of the time. The history
/// must be one that solve() returned for this case.
std::vector<ContactSnapshot> contact_snapshots(const ImpactCase& impact, const History& history);

}  // namespace dashpad
