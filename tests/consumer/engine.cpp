// The solver and HIC without files: all that this program links of Dashpad is dashpad::engine.

#include <cmath>
#include <cstdio>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/metrics.hpp"

int main() {
  dashpad::ImpactCase impact;
  impact.impactor = {.mass = 4.5, .nose = dashpad::Sphere{0.08}, .speed = 5};
  impact.pad.thickness = 0.05;
  impact.pad.material.name = dashpad::foam_of_the_case;
  impact.pad.material.law = dashpad::Elastic{.modulus = 5e5};
  impact.support = dashpad::Support::linear(200e3);

  const dashpad::Solution solution = dashpad::solve(impact);
  const double hic =
      dashpad::injury::hic({solution.history.time, solution.history.acceleration}, 15e-3).value;
  std::printf("HIC15 %.1f\n", hic);
  return solution.summary.trustworthy() && std::isfinite(hic) && hic > 0 ? 0 : 1;
}
