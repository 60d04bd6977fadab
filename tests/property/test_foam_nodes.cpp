/// The contact integral of a foam by vectors of nodes against one node after the other.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/contact/foam_contact.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

constexpr double thickness = 0.03;

/// Largest difference of the force and of its relaxing along a path, over the largest of each.
template <class Law>
double worst_difference(const Law& law, const Sections& nose, std::uint64_t seed, double resolution) {
  FoamContact by_vectors(law, thickness, nose, 1, ColumnMath::vector);
  FoamContact plain(law, thickness, nose, 1, ColumnMath::plain);
  by_vectors.start(resolution, thickness);
  plain.start(resolution, thickness);
  std::mt19937_64 generator(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  double y = 0, time = 0;
  double force = 0, force_difference = 0;
  double relaxing = 0, relaxing_difference = 0;
  for (int leg = 0; leg < 8; ++leg) {
    const double to = uniform(leg == 0 ? 0.3 : 0, 0.98) * thickness;
    const double step =
        std::abs(to - y) / thickness / law.curves.slowest_rate / std::pow(10, uniform(-1, 5)) / 4;
    for (int i = 0; i < 4; ++i) {
      const double advance = (to - y) / (4 - i);
      const PadTrial a = by_vectors.trial(advance, time, step);
      const PadTrial b = plain.trial(advance, time, step);
      force = std::max(force, std::abs(b.force));
      force_difference = std::max(force_difference, std::abs(a.force - b.force));
      const double held = plain.force_rate_when_held(b);
      relaxing = std::max(relaxing, std::abs(held));
      relaxing_difference =
          std::max(relaxing_difference, std::abs(by_vectors.force_rate_when_held(a) - held));
      by_vectors.accept(a);
      plain.accept(b);
      y += advance, time += step;
    }
  }
  EXPECT_TRUE(std::isfinite(force) && std::isfinite(relaxing)) << "seed " << seed;
  return std::max(force_difference / force, relaxing > 0 ? relaxing_difference / relaxing : 0);
}

/// All kinds of foams; few nodes, and more than are taken at a time.
TEST(FoamNodes, ByVectorsAreThoseOneByOne) {
  double worst = 0;
  const auto expect_alike = [&](const auto& law, const Sections& nose, std::uint64_t seed,
                                double resolution) {
    const double difference = worst_difference(law, nose, seed, resolution);
    EXPECT_LE(difference, 1e-12) << "seed " << seed << ", resolution " << resolution;
    worst = std::max(worst, difference);
  };
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
    for (const double resolution : {0.2, 1e-3}) {
      // The last is a blunt cone, whose section grows no more from a depth on.
      const Sections noses[] = {Sphere{0.08}.sections(), Sphere{0.01}.sections(), {1e-4, 0.02, -0.3, 0.02}};
      const Sections& nose = noses[seed % 3];
      expect_alike(random_foam(seed), nose, seed, resolution);
      expect_alike(random_crushable_foam(seed), nose, seed, resolution);
    }
  fmt::print("largest difference {:.1e}\n", worst);
}

}  // namespace
}  // namespace dashpad::test
