// Solves one impact through the installed headers and prints the peak force.
//
// An elastic pad on a rigid support has a closed form: at the penetration Y
//   F = (2 pi E / L) (R Y^2 / 2 - Y^3 / 6),   work = (2 pi E / L) (R Y^3 / 6 - Y^4 / 24),
// so the speed that reaches Y = 10 mm, and the peak force there, are known.

#include <cmath>
#include <cstdio>
#include <numbers>

#include "dashpad/impact/solve.hpp"
#include "dashpad/version.hpp"

int main() {
  constexpr double modulus = 1e5, thickness = 0.05, radius = 0.1, mass = 1, penetration = 0.01;
  constexpr double scale = 2 * std::numbers::pi * modulus / thickness;
  const double work = scale * (radius * std::pow(penetration, 3) / 6 - std::pow(penetration, 4) / 24);
  const double expected_force =
      scale * (radius * std::pow(penetration, 2) / 2 - std::pow(penetration, 3) / 6);

  dashpad::ImpactCase impact;
  impact.title = "elastic pad on a rigid support";
  impact.impactor = {.mass = mass, .nose = dashpad::Sphere{radius}, .speed = std::sqrt(2 * work / mass)};
  impact.pad.thickness = thickness;
  impact.pad.material.name = dashpad::foam_of_the_case;
  impact.pad.material.law = dashpad::Elastic{.modulus = modulus};
  impact.support = dashpad::Support::rigid();

  const dashpad::Summary summary = dashpad::solve(impact).summary;
  if (!summary.trustworthy() || !summary.peak_force) {
    std::printf("no peak force: %s\n", dashpad::to_string(summary.status).c_str());
    return 1;
  }
  std::printf("dashpad %s: peak force %.3f N, closed form %.3f N\n", dashpad::version().data(),
              *summary.peak_force, expected_force);
  return std::abs(*summary.peak_force / expected_force - 1) < 1e-3 ? 0 : 1;
}
