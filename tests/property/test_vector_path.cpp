/// The fast path (columns by vectors, closed form of the loading) against the plain one, on random cases.
/// Take more with
///
///   compare_answers --cases 100000
///   DASHPAD_RANDOM_SEED=1234 DASHPAD_RANDOM_CASES=1 test_property --gtest_filter=VectorPath.*

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "property/answer_comparison.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

constexpr std::uint64_t compared_cases = 200;
constexpr double path_tolerance = 1e-3;

/// Shares of the cases: at least so many can be compared, at most so many end with another status.
void expect_agreement(ImpactCase (*draw)(std::uint64_t), double min_compared, double max_other_status) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", compared_cases);
  Solver solver;
  std::uint64_t compared = 0;
  std::uint64_t other_status = 0;
  double worst = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const AnswerComparison paths = compare_paths(solver, draw(seed), path_tolerance);
    if (paths.status != paths.reference_status) ++other_status;
    if (!paths.compared()) continue;
    ++compared;
    EXPECT_TRUE(paths.alike(2 * path_tolerance)) << "seed " << seed << ": " << paths.text();
    for (const ComparedFigure& figure : paths.figures) worst = std::max(worst, figure.difference);
  }
  fmt::print("compared {} of {}; status differs in {}; largest difference {:.1e}\n", compared, cases,
             other_status, worst);
  EXPECT_GE(static_cast<double>(compared), min_compared * static_cast<double>(cases));
  EXPECT_LE(static_cast<double>(other_status), max_other_status * static_cast<double>(cases) + 1);
}

TEST(VectorPath, AgreesWithThePlainOneOnOrdinaryCases) { expect_agreement(ordinary_case, 0.98, 0.005); }
TEST(VectorPath, AgreesWithThePlainOneOnEveryNose) { expect_agreement(nose_case, 0.98, 0.005); }
TEST(VectorPath, AgreesWithThePlainOneOnExtremeCases) { expect_agreement(random_case, 0.9, 0.03); }

/// The same whatever was solved before in the same memory.
TEST(VectorPath, LeavesNothingInTheSolversMemory) {
  const Options fast{.tolerance = path_tolerance};
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
