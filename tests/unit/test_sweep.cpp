/// Columns by vectors against the laws' own functions, one column at a time; and the force of a loading in
/// closed form against quadrature.

#include "model/contact/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <numbers>
#include <random>

#include "model/contact/loading_force.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr double thickness = 0.03;
constexpr double start = 4e-3;  // s since first contact
constexpr double duration = 2e-4;

template <class Law>
class SweepOfLaw : public testing::Test {};
TYPED_TEST_SUITE(SweepOfLaw, LawsWithMemory);

/// A step of columns in any state, from `before` to `after`; their number is no multiple of a vector's lanes.
template <class Law>
void expect_alike(double before, double after, double largest) {
  const Law law = sample_law<Law>();
  const PowerShape power(law.exponents());
  const auto rate = law.rate_part((after - before) / (thickness * duration));
  const auto time = law.time_part(start, start + duration);
  constexpr std::size_t count = 37;
  ColumnStorage columns;
  std::mt19937_64 draw(7);
  for (std::size_t j = 0; j < count; ++j) {
    // From the axis to a last column that is hardly touched.
    const double depth = after * (1 - 1e-9) * static_cast<double>(j) / (count - 1);
    columns.insert(j, depth);
  }
  // The parts of the columns before, from a step up to there.
  const SweepStep to_before{columns.depth(), count, thickness, 0, before, before};
  const auto& of_law = sweeps(ColumnMath::plain).of<Law>();
  of_law.step(law, power, rate, time, to_before, columns.next_state, columns.now);
  for (std::size_t j = 0; j < count; ++j)
    columns.now.stress[j] =
        columns.depth()[j] < before ? 1e5 * static_cast<double>(draw() >> 11) * 0x1p-53 : 0;

  const SweepStep step{columns.depth(), count, thickness, before, after, largest};
  sweeps(ColumnMath::vector).of<Law>().step(law, power, rate, time, step, columns.now, columns.next_state);
  for (std::size_t j = 0; j < count; ++j) {
    const double depth = columns.depth()[j];
    const Strain strain{(after - depth) / thickness, ((thickness - after) + depth) / thickness};
    const double strain_before = std::max((before - depth) / thickness, 1e-300);
    const double largest_strain = (largest - depth) / thickness;
    const double share_of_step = depth > before ? (after - depth) / (after - before) : 1;
    const auto value = power.at(strain);
    const double envelope = dashpad::envelope(law, power, strain, rate, largest_strain);
    const double remainder =
        columns.now.stress[j] -
        dashpad::envelope(law, power, strain_of(strain_before), rate, std::max(largest_strain, 1e-300));
    const scalar::Formulas<Law> formulas{law, power, rate, time};
    const double expected = envelope + remainder * formulas.decay(strain_before, strain.value, share_of_step);
    const double size = std::abs(envelope) + std::abs(remainder);
    EXPECT_NEAR(columns.next_state.stress[j], expected, 1e-12 * size) << "column " << j;
    expect_relative(columns.next_state.shape[j], value.shape, 1e-13, "A");
    // Above a half w is a difference from the offset of its expansion; for law 2 it is the exact e^2 / 2.
    const double of_measure = value.measure + (strain.value > 0.5 ? std::abs(power.offset()) : 0);
    EXPECT_NEAR(columns.next_state.measure[j], value.measure, 1e-12 * of_measure) << "column " << j;
    EXPECT_NEAR(columns.next_state.ratio[j], expected / value.shape, 1e-12 * size / value.shape)
        << "column " << j;
  }
}

TYPED_TEST(SweepOfLaw, LoadingIsTheLaw) {
  expect_alike<TypeParam>(0.2 * thickness, 0.21 * thickness, 0.2 * thickness);
  expect_alike<TypeParam>(0.96 * thickness, 0.97 * thickness, 0.96 * thickness);
}
TYPED_TEST(SweepOfLaw, UnloadingIsTheLaw) {
  expect_alike<TypeParam>(0.9 * thickness, 0.88 * thickness, 0.97 * thickness);
}
TYPED_TEST(SweepOfLaw, HoldingIsTheLaw) {
  expect_alike<TypeParam>(0.9 * thickness, 0.9 * thickness, 0.97 * thickness);
}

/// Cells with g above, below and through zero.
TEST(sum_of_cells, takes_the_part_that_presses) {
  ColumnStorage columns;
  const std::vector<double> g{3, 1, -1, -2, 4, 4, 0, 1, -3, 2, 5};
  for (std::size_t j = 0; j < g.size(); ++j) {
    columns.insert(j, static_cast<double>(j));
    columns.set_weights(j, 1 + 0.1 * static_cast<double>(j), 2 - 0.1 * static_cast<double>(j));
    columns.now.measure[j] = 100 - static_cast<double>(j * j);
    columns.now.ratio[j] = g[j];
  }
  double expected = 0;
  for (std::size_t j = 0; j + 1 < g.size(); ++j) {
    const double width = columns.now.measure[j] - columns.now.measure[j + 1];
    const double inner = g[j] * (1 + 0.1 * static_cast<double>(j));
    const double outer = g[j + 1] * (2 - 0.1 * static_cast<double>(j));
    const double top = std::max(inner, outer);
    const double bottom = std::min(inner, outer);
    const double share = bottom >= 0 ? 1 : top <= 0 ? 0 : top / (top - bottom);
    expected += (top + std::max(bottom, 0.0)) / 2 * share * width;
    for (const ColumnMath math : {ColumnMath::vector, ColumnMath::plain})
      expect_relative(sweeps(math).sum_of_cells(columns.now, columns.weights(), j + 1), expected, 1e-14,
                      fmt::format("{} cells", j + 1));
  }
}

TEST(contact_shape, is_the_integral_of_the_shape_over_the_contact) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const PowerExponents x : {PowerExponents{0.675, 1.09}, {1, 0}, {0.3, 2}, {0.5, 0.7}})
    for (const double sphere : {0.08, 0.01}) {
      ContactShape shape({2, 3}, 1, Sphere{1}.sections());
      shape.set(x, thickness, Sphere{sphere}.sections());
      for (const double share : {1e-4, 0.1, 0.5, 0.9, 0.99, 1 - 1e-6}) {
        const double depth = share * thickness;
        const double edge = std::min(depth, sphere);
        const auto f = [&](double s, double to_end) {
          const double above = to_end > 0 ? to_end + (depth - edge) : depth - s;
          return above > 0 ? std::pow(above / thickness, x.m) *
                                 std::pow((thickness - depth + s) / thickness, -x.n) * (sphere - s)
                           : 0;
        };
        const double expected = 2 * std::numbers::pi * quadrature.integrate(f, 0.0, edge);
        expect_relative(shape.at(depth), expected, 1e-8,
                        fmt::format("m {} n {} R {} Y/L {}", x.m, x.n, sphere, share));
      }
    }
  EXPECT_EQ(ContactShape({0.7, 1}, thickness, Sphere{0.08}.sections()).at(0), 0);
}

}  // namespace
}  // namespace dashpad::test
