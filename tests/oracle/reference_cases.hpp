#pragma once
/// The converged reference solutions of data/reference-cases.csv, in SI.

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::oracle {

/// Gravity of the reference figures' "weight", m/s2: 386.4 in/s2.
inline constexpr double reference_gravity = 386.4 * 0.0254;

struct ReferenceCase {
  std::string id;
  ImpactCase impact;
  double peak_force = 0;          ///< N
  double time_of_peak_force = 0;  ///< s
  double peak_motion = 0;         ///< m
  double peak_penetration = 0;    ///< m
  Moment weight;                  ///< rebound speeds are negative velocities
  Moment release;
  Moment contact_end;  ///< force below a thousandth of its peak
  double energy_loss = 0;
};

/// The pad of the report's Appendix C (Ensolite AAC), laws 4 and 5, from psi to Pa.
NineParameter ensolite_nine();
TwentyOneParameter ensolite_twenty_one();

/// Throws std::runtime_error for a file or a line that it cannot read.
std::vector<ReferenceCase> read_reference_cases(const std::filesystem::path& file);
/// The case of that id; throws std::runtime_error if there is none.
ReferenceCase reference_case(const std::filesystem::path& file, const std::string& id);

}  // namespace dashpad::oracle
