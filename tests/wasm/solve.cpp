// Reads a case in WebAssembly, refuses a spoilt one, and compares the peak force with its closed form, that
// of tests/consumer/main.cpp.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/version.hpp"
#include "input/disk.hpp"

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

namespace dashpad::input {
// There is no disk, so no card and no profile of a nose.
bool is_there(const std::filesystem::path& /*file*/) { return false; }
bool is_link(const std::filesystem::path& /*file*/) { return false; }
Reading<std::string> content_of(const std::filesystem::path& file, std::size_t /*most*/) {
  return fault_of_file(file, "no such file");
}
Reading<std::vector<std::filesystem::path>> toml_files(const std::filesystem::path& /*folder*/,
                                                       std::string_view /*of*/) {
  return std::vector<std::filesystem::path>{};
}
}  // namespace dashpad::input

namespace {

/// Whether every fault of a spoilt case is found, each in its line, without an exception.
bool refuses(std::string text) {
  const auto spoil = [&](std::string_view from, std::string_view to) {
    text.replace(text.find(from), from.size(), to);
  };
  spoil("kg", "kpg"), spoil("thickness", "thicknes"), spoil("elastic", "elastik"), spoil("rigid", "soft");
  std::string lines;
  for (const auto& fault : dashpad::input::read_case_text(text, "case.toml", "materials").faults())
    lines += fmt::format("{} ", fault.line);
  const bool is_right = lines == "2 5 6 8 11 ";
  const auto of_nothing = dashpad::input::read_case_text("[", "case.toml", "materials");
  const auto of_a_card = dashpad::input::read_material("materials/vn600.toml");
  if (!is_right || of_nothing || of_a_card) std::printf("faults in lines %s\n", lines.c_str());
  return is_right && !of_nothing && !of_a_card;
}

}  // namespace

int main() {
  constexpr double modulus = 1e5, thickness = 0.05, radius = 0.1, mass = 1, penetration = 0.01;
  constexpr double scale = 2 * std::numbers::pi * modulus / thickness;
  const double work = scale * (radius * std::pow(penetration, 3) / 6 - std::pow(penetration, 4) / 24);
  const double expected_force =
      scale * (radius * std::pow(penetration, 2) / 2 - std::pow(penetration, 3) / 6);

  const std::string text = fmt::format(R"([impactor]
mass = "{} kg"
radius = "{} m"
speed = "{} m/s"
[pad]
thickness = "{} m"
neighbours = 0
law = "elastic"
parameters.modulus = "{} Pa"
[support]
type = "rigid"
)",
                                       mass, radius, std::sqrt(2 * work / mass), thickness, modulus);
  if (!refuses(text)) return 1;
  const auto read = dashpad::input::read_case_text(text, "case.toml", "materials");
  for (const dashpad::input::Fault& fault : read.faults()) std::printf("%s\n", with_excerpt(fault).c_str());
  if (!read) return 1;
  const dashpad::ImpactCase& impact = read->impact;

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
