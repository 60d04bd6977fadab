/// The order of the method on smooth pieces: the error of the time steps and that of the columns, each alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "shared/samples.hpp"
#include "verification/order.hpp"

namespace dashpad::test {
namespace {

template <class Law>
class Order : public testing::Test {};
TYPED_TEST_SUITE(Order, SmoothLaws);

/// Well before the turning point. Five halvings, against a step a quarter of the finest of them. With memory
/// the force of Eq. 23 is a parabola, whose error is of third order: on a rigid support it outweighs that of
/// the constant rate of Eq. 9 for all steps that rounding leaves room for, and on a yielding one it shows.
TYPED_TEST(Order, OfTheTimeStepsIsTwoAtLeast) {
  for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
    const ImpactCase impact = impact_on(sample_law<TypeParam>(), support);
    const double time = 0.4 * impact.pad.thickness / impact.impactor.speed;
    constexpr int levels = 5;
    const int coarsest = support.is_rigid() ? 16 : 128;
    const double highest = IsMemoryless<TypeParam> ? 2.2 : support.is_rigid() ? 3.2 : 2.3;
    const State fine = loaded_for(impact, time, coarsest << (levels + 1));
    std::vector<double> size, of_velocity, of_penetration;
    for (int level = 0; level < levels; ++level) {
      const int steps = coarsest << level;
      const State end = loaded_for(impact, time, steps);
      size.push_back(time / steps);
      of_velocity.push_back(std::abs(end.velocity - fine.velocity) / impact.impactor.speed);
      of_penetration.push_back(std::abs(end.penetration - fine.penetration) / fine.penetration);
    }
    const std::string on =
        fmt::format("{}, {} support: ", TypeParam::name, support.is_rigid() ? "rigid" : "linear");
    expect_order(size, of_velocity, on + "velocity", highest);
    expect_order(size, of_penetration, on + "penetration", highest);
  }
}

template <class Law>
class ColumnOrder : public testing::Test {};
TYPED_TEST_SUITE(ColumnOrder, LawsWithMemory);

/// The force at the end of one path of the penetration, by ever more columns.
TYPED_TEST(ColumnOrder, IsTwo) {
  constexpr double thickness = 0.03, speed = 3;
  const Sections nose = Sphere{0.08}.sections();
  const double depth = 0.6 * thickness;
  const auto force_at = [&](double resolution) {
    ColumnField<TypeParam> field(sample_law<TypeParam>(), thickness, nose);
    field.start(resolution, depth);
    constexpr int steps = 400;
    double force = 0;
    for (int i = 0; i < steps; ++i) {
      const double from = depth * i / steps, advance = depth / steps;
      const PadTrial trial = field.trial(advance, from / speed, advance / speed);
      field.accept(trial);
      force = trial.force;
    }
    return force;
  };
  const double fine = force_at(0.08 / 256);
  std::vector<double> size, error;
  for (double resolution = 0.08; resolution > 0.08 / 20; resolution /= 2) {
    size.push_back(resolution);
    error.push_back(relative_error(force_at(resolution), fine));
  }
  expect_order(size, error, fmt::format("{}: force, by columns", TypeParam::name));
}

}  // namespace
}  // namespace dashpad::test
