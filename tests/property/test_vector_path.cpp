/// The fast path (columns by vectors, closed form of the loading) against the plain one, on random cases.
/// Take more with
///
///   DASHPAD_RANDOM_CASES=100000 test_property --gtest_filter=VectorPath.*

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "dashpad/impact/solve.hpp"
#include "dashpad/impact/solver.hpp"
#include "property/random_case.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr std::uint64_t default_cases = 200;
/// Work of one run in columns and steps is bounded, so that a few extreme cases do not take all the time.
constexpr Options fast{.tolerance = 1e-3, .most_steps = 3000};
constexpr Options plain{.tolerance = 1e-3, .most_steps = 3000, .plain = true};

std::uint64_t environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr || *text == '\0' ? otherwise : std::strtoull(text, nullptr, 10);
}

/// Both have errors of their own, within the tolerance each.
bool alike(double a, double b, double scale) { return std::abs(a - b) <= 2 * fast.tolerance * scale; }

TEST(VectorPath, AgreesWithThePlainOne) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", default_cases);
  Solver solver;
  std::uint64_t compared = 0;
  std::uint64_t other_status = 0;
  double worst = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const ImpactCase impact = random_case(seed);
    const Summary a = solver.solve(impact, fast).summary;
    const Summary b = solver.solve(impact, plain).summary;
    if (a.status != b.status) ++other_status;
    if (!a.trustworthy() || !b.trustworthy()) continue;
    SCOPED_TRACE(fmt::format("seed {}", seed));
    EXPECT_EQ(a.status, b.status);
    if (a.status != b.status) continue;
    ++compared;
    EXPECT_EQ(a.peak_force.has_value(), b.peak_force.has_value());
    if (a.peak_force && b.peak_force) {
      worst = std::max(worst, relative_error(*a.peak_force, *b.peak_force));
      EXPECT_TRUE(alike(*a.peak_force, *b.peak_force, *b.peak_force))
          << "peak force " << *a.peak_force << ", " << *b.peak_force;
    }
    EXPECT_TRUE(alike(a.peak_penetration, b.peak_penetration, b.peak_penetration))
        << "peak penetration " << a.peak_penetration << ", " << b.peak_penetration;
    if (a.rebound_speed && b.rebound_speed)
      EXPECT_TRUE(alike(*a.rebound_speed, *b.rebound_speed, impact.impactor.speed))
          << "rebound speed " << *a.rebound_speed << ", " << *b.rebound_speed;
  }
  fmt::print("compared {} of {}; status differs in {}; largest difference of the peak force {:.1e}\n",
             compared, cases, other_status, worst);
  EXPECT_GE(static_cast<double>(compared), 0.9 * static_cast<double>(cases));
  EXPECT_LE(static_cast<double>(other_status), 0.03 * static_cast<double>(cases) + 1);
}

/// The same whatever was solved before in the same memory.
TEST(VectorPath, LeavesNothingInTheSolversMemory) {
  Solver used;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const ImpactCase impact = random_case(seed);
    const Solution& a = used.solve(impact, fast);
    const Solution b = solve(impact, fast);
    EXPECT_EQ(a.summary.peak_force, b.summary.peak_force) << "seed " << seed;
    EXPECT_EQ(a.summary.rebound_speed, b.summary.rebound_speed) << "seed " << seed;
    EXPECT_EQ(a.history.force, b.history.force) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dashpad::test
