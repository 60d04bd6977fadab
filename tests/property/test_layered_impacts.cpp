/// Impacts on random pads of layers. Repeat one case with DASHPAD_RANDOM_SEED and DASHPAD_RANDOM_CASES.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

std::string layers_in_words(const ImpactCase& impact) {
  std::string text;
  for (const PadLayer& layer : impact.pad.layers) text += fmt::format(" {}", name_of(layer.material.law));
  return text;
}

/// No impact gives back more than it took, and next to all are solved. Their strains make up that of the pad.
TEST(LayeredImpacts, LoseEnergyAndAreSolved) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", 40);
  std::map<std::string, std::uint64_t> count;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const ImpactCase impact = layered_case(seed);
    SCOPED_TRACE(fmt::format("seed {},{}", seed, layers_in_words(impact)));
    ASSERT_TRUE(violations(impact).empty());
    Solution solution;
    ASSERT_NO_THROW(solution = solve(impact, {.tolerance = 1e-2}));
    const Summary& s = solution.summary;
    ++count[to_string(s.status)];
    EXPECT_FALSE(gained_energy(s)) << "absorbed " << s.energy_absorbed_fraction << " of the energy, "
                                   << to_string(s.status);
    EXPECT_TRUE(std::isfinite(s.peak_motion + s.peak_penetration + s.energy.residual));
    if (s.release) {
      EXPECT_LE(s.restitution.value(), 1 + s.errors.rebound_speed);
    }
    const History& h = solution.history;
    ASSERT_EQ(h.layer_strain.size(), impact.pad.layers.size());
    for (std::size_t k = 0; k < h.size(); ++k) {
      ASSERT_TRUE(std::isfinite(h.force[k]) && h.force[k] >= 0);
      double sum = 0;
      for (std::size_t i = 0; i < impact.pad.layers.size(); ++i)
        sum += impact.pad.layers[i].thickness * h.layer_strain[i][k];
      ASSERT_NEAR(sum, h.penetration[k], 1e-8 * impact.pad.thickness) << "entry " << k;
    }
  }
  for (const auto& [status, number] : count) fmt::print("{:20} {:5} of {}\n", status, number, cases);
  EXPECT_LE(static_cast<double>(count[to_string(Status::tolerance_not_met)]),
            0.03 * static_cast<double>(cases));
}

/// Twice the stress of every layer, twice the mass: the same motion under twice the force.
TEST(LayeredImpacts, OfTwiceTheMassOnTwiceTheStressMoveTheSame) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    ImpactCase impact = layered_case(seed);
    SCOPED_TRACE(fmt::format("seed {}", seed));
    impact.support = Support::rigid();
    const Options options{.tolerance = 1e-2};
    const Summary once = solve(impact, options).summary;
    impact.impactor.mass *= 2;
    for (PadLayer& layer : impact.pad.layers) layer.condition.scale *= 2;
    const Summary twice = solve(impact, options).summary;
    ASSERT_EQ(once.status, twice.status);
    constexpr double limit = 2e-2;
    EXPECT_NEAR(twice.peak_penetration / once.peak_penetration, 1, limit);
    ASSERT_EQ(once.peak_force.has_value(), twice.peak_force.has_value());
    if (once.peak_force) {
      EXPECT_NEAR(*twice.peak_force / *once.peak_force, 2, 2 * limit);
    }
  }
}

}  // namespace
}  // namespace dashpad::test
