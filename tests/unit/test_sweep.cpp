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

constexpr std::size_t count = 37;  // no multiple of a vector's lanes

/// Columns in any state at the penetration `before`, from the axis to one hardly touched at `after`.
template <class Law>
ColumnStorage columns_before(const Law& law, double before, double after) {
  ColumnStorage columns;
  for (std::size_t j = 0; j < count; ++j)
    columns.insert(j, after * (1 - 1e-9) * static_cast<double>(j) / (count - 1));
  // Their parts, from a step up to there.
  const SweepStep to_before{columns.depth(), count, thickness, 0, before, before};
  const auto& of_law = sweeps(ColumnMath::plain).of<Law>();
  of_law.step(law, PowerShape(law.exponents()), law.rate_part(before / (thickness * duration)),
              law.time_part(start, start + duration), to_before, columns.tried, columns.now, nullptr);
  std::mt19937_64 draw(7);
  for (std::size_t j = 0; j < count; ++j)
    columns.now.stress[j] =
        columns.depth()[j] < before ? 1e5 * static_cast<double>(draw() >> 11) * 0x1p-53 : 0;
  return columns;
}

/// A step of columns is that of the law's own functions.
template <class Law>
void expect_alike(double before, double after, double largest) {
  const Law law = sample_law<Law>();
  const PowerShape power(law.exponents());
  const auto rate = law.rate_part((after - before) / (thickness * duration));
  const auto time = law.time_part(start, start + duration);
  ColumnStorage columns = columns_before(law, before, after);
  const SweepStep step{columns.depth(), count, thickness, before, after, largest};
  sweeps(ColumnMath::vector)
      .of<Law>()
      .step(law, power, rate, time, step, columns.now, columns.tried, nullptr);
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
    EXPECT_NEAR(columns.tried.stress[j], expected, 1e-12 * size) << "column " << j;
    expect_relative(columns.tried.shape[j], value.shape, 1e-13, "A");
    // Above a half w is a difference from the offset of its expansion; for law 2 it is the exact e^2 / 2.
    const double of_measure = value.measure + (strain.value > 0.5 ? std::abs(power.offset()) : 0);
    EXPECT_NEAR(columns.tried.measure[j], value.measure, 1e-12 * of_measure) << "column " << j;
    EXPECT_NEAR(columns.tried.ratio[j], expected / value.shape, 1e-12 * size / value.shape) << "column " << j;
  }
}

/// The largest difference of a step moved from `after` by a share of the step from one computed there, over
/// the columns whose series suffice, at least half of them.
template <class Law>
double error_of_moved(double before, double after, double share, double max_bend) {
  const Law law = sample_law<Law>();
  const PowerShape power(law.exponents());
  const auto time = law.time_part(start, start + duration);
  const auto& of_law = sweeps(ColumnMath::vector).of<Law>();
  ColumnStorage columns = columns_before(law, before, after);
  const double largest = std::max(before, 0.3 * thickness);
  const auto rate_to = [&](double end) { return law.rate_part((end - before) / (thickness * duration)); };
  SweepStep step{columns.depth(), count, thickness, before, after, largest};
  of_law.step(law, power, rate_to(after), time, step, columns.now, columns.tried, &columns.series);

  step.after += share * (after - before);
  while (columns.depth()[step.count - 1] >= step.after) --step.count;
  const auto rate = rate_to(step.after);
  const MovedStep move{(step.after - after) / thickness, max_bend};
  const std::size_t moved = of_law.move(law, power, rate, time, step, columns.now, columns.moved, move,
                                        columns.tried, columns.series);
  EXPECT_GE(moved, count / 2);
  EXPECT_LE(moved, count);
  of_law.step(law, power, rate, time, step, columns.now, columns.tried, nullptr);
  double worst = 0;
  const auto compare = [&](const double* by_series, const double* computed) {
    for (std::size_t j = 0; j < moved; ++j)
      if (computed[j] != 0) worst = std::max(worst, std::abs(by_series[j] / computed[j] - 1));
  };
  compare(columns.moved.stress, columns.tried.stress);
  compare(columns.moved.shape, columns.tried.shape);
  compare(columns.moved.measure, columns.tried.measure);
  compare(columns.moved.ratio, columns.tried.ratio);
  for (std::size_t k = 0; k < scalar::Formulas<Law>::parts; ++k)
    compare(columns.moved.part[k], columns.tried.part[k]);
  return worst;
}

TYPED_TEST(SweepOfLaw, MovesByItsSeriesWithAnErrorOfThirdOrder) {
  for (const double to : {0.21, 0.19}) {
    SCOPED_TRACE(to);
    const auto error = [&](double share, double max_bend) {
      return error_of_moved<TypeParam>(0.2 * thickness, to * thickness, share, max_bend);
    };
    EXPECT_LT(error(0.02, 1e-4), 1e-5);
    // Over the same columns, as hardly any is left out.
    const double coarse = error(0.04, 1);
    if (coarse > 1e-12) {
      EXPECT_NEAR(std::log2(coarse / error(0.02, 1)), 3, 0.5);
    }
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
        expect_relative(shape.around(depth).value, expected, 1e-8,
                        fmt::format("m {} n {} R {} Y/L {}", x.m, x.n, sphere, share));
      }
    }
  EXPECT_EQ(ContactShape({0.7, 1}, thickness, Sphere{0.08}.sections()).around(0).value, 0);
}

TEST(contact_shape, moves_by_its_series_with_an_error_of_third_order) {
  for (const double nose : {0.08, 0.01}) {
    const ContactShape shape({0.675, 1.09}, thickness, Sphere{nose}.sections());
    for (const double share : {0.1, 0.5, 0.9}) {
      SCOPED_TRACE(fmt::format("R {} Y/L {}", nose, share));
      const ContactShape::Series k = shape.around(share * thickness);
      const auto error = [&](double x) {
        const double moved = k.value + x * (k.first + x * k.second);
        return std::abs(moved / shape.around(share * thickness + x).value - 1);
      };
      const double x = 0.01 * std::min(share, 1 - share) * thickness;
      EXPECT_LT(error(x), 5e-6);
      EXPECT_NEAR(std::log2(error(2 * x) / error(x)), 3, 0.3);
    }
  }
}

}  // namespace
}  // namespace dashpad::test
