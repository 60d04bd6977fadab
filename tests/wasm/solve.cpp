// Solves one impact in WebAssembly and compares the peak force with its closed form, that of
// tests/consumer/main.cpp.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/hic.hpp"
#include "dashpad/version.hpp"

extern "C" {
// The C++ library has no exceptions, so that one ends the program; everything that Dashpad throws is a
// std::exception first.
void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
void __cxa_throw(void* thrown, void* /*type*/, void (* /*destroy*/)(void*)) {
  std::fprintf(stderr, "%s\n", static_cast<const std::exception*>(thrown)->what());
  std::exit(2);
}
// Debian's builtins of the compiler guard their stack, and its C library has no guard.
std::uintptr_t __stack_chk_guard = 0x5bd1e995;
void __stack_chk_fail() { std::abort(); }
}

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

  const dashpad::Solution solution = dashpad::solve(impact);
  const dashpad::Summary& summary = solution.summary;
  if (!summary.trustworthy() || !summary.peak_force) {
    std::printf("no peak force: %s\n", dashpad::to_string(summary.status).c_str());
    return 1;
  }
  const double hic =
      dashpad::injury::hic({solution.history.time, solution.history.acceleration}, 15e-3).value;
  std::printf("dashpad %s: peak force %.3f N, closed form %.3f N; HIC15 %.1f\n", dashpad::version().data(),
              *summary.peak_force, expected_force, hic);
  return std::abs(*summary.peak_force / expected_force - 1) < 1e-3 && hic > 0 ? 0 : 1;
}
