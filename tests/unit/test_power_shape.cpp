/// A(e) = e^m (1 - e)^-n and its integral w.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

const std::vector<PowerExponents> exponents{
    {0.675, 1.09},   {1, 0},          {0, 0},          {0.2, 0.5},   {0.5, 1},     {0.5, 2},   {1, 3}, {1, 4},
    {0.7, 1 + 1e-9}, {0.7, 1 + 1e-5}, {0.7, 1 - 1e-4}, {0.7, 2.001}, {0.3, 1.999}, {0.05, 2.7}};

/// By its complement: exact near full compression.
Strain with_gap(double complement) { return {1 - complement, complement}; }

/// Where n is close to a whole number but not equal to it, w is a difference of two large terms and loses
/// digits: the contact integral, which is taken over w, is then good to this.
double accuracy_of(PowerExponents x) {
  const double distance = std::abs(x.n - std::round(x.n));
  return x.n > 0.5 && distance > 0 && distance < 0.01 ? 3e-5 : 1e-8;
}

class PowerShapes : public testing::TestWithParam<PowerExponents> {
 protected:
  [[nodiscard]] double shape(Strain e) const {
    return std::pow(e.value, GetParam().m) * std::pow(e.complement, -GetParam().n);
  }
  /// Integral of A between two strains, in x = ln e below and x = ln(1 - e) above a half.
  [[nodiscard]] double integral(Strain from, Strain to) const {
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
    if (to.value <= 0.5)
      return Quadrature::integrate([&](double x) { return shape(strain_of(std::exp(x))) * std::exp(x); },
                                   std::log(from.value), std::log(to.value), 12, 1e-14);
    return Quadrature::integrate([&](double x) { return shape(with_gap(std::exp(x))) * std::exp(x); },
                                 std::log(to.complement), std::log(from.complement), 12, 1e-14);
  }
  const PowerShape power{GetParam()};
  const double accuracy = accuracy_of(GetParam());
};

TEST_P(PowerShapes, AreTheirFormula) {
  for (const double gap : {0.999999, 0.9, 0.5, 0.1, 1e-6, 1e-12}) {
    const auto value = power.at(with_gap(gap));
    expect_relative(value.shape, shape(with_gap(gap)), 1e-13, fmt::format("A at gap {}", gap));
    expect_relative(value.log_complement, std::log(gap), 1e-13, "ln(1 - e)");
  }
}

TEST_P(PowerShapes, HaveTheirIntegralOnBothBranches) {
  const std::vector<Strain> places{strain_of(1e-12), strain_of(1e-6), strain_of(1e-2), strain_of(0.2),
                                   strain_of(0.45),  strain_of(0.5),  with_gap(0.45),  with_gap(0.2),
                                   with_gap(1e-2),   with_gap(1e-4),  with_gap(1e-6),  with_gap(1e-9),
                                   with_gap(1e-12)};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double difference = power.at(places[i]).measure - power.at(places[i - 1]).measure;
    const double expected = integral(places[i - 1], places[i]);
    EXPECT_NEAR(difference, expected, accuracy * expected + 1e-15 * power.at(places[i]).measure)
        << "from " << places[i - 1].value << " to a gap of " << places[i].complement;
  }
}

TEST_P(PowerShapes, StartAtZeroAsAPowerOfTheStrain) {
  EXPECT_EQ(power.at({}).shape, 0);
  EXPECT_EQ(power.at({}).measure, 0);
  const double e = 1e-9;
  expect_relative(power.at(strain_of(e)).measure, std::pow(e, GetParam().m + 1) / (GetParam().m + 1), 1e-8,
                  "w");
}

/// dw/de = A; the step of the difference scales with the distance to the nearer end.
TEST_P(PowerShapes, AreTheSlopeOfTheirIntegral) {
  for (const double strain : {1e-4, 0.1, 0.3, 0.49, 0.5, 0.51, 0.7, 0.99, 0.9999}) {
    const double h = 1e-3 * std::min(strain, 1 - strain);
    const auto w = [&](double x) { return power.at({strain + x, 1 - strain - x}).measure; };
    const double slope = (8 * (w(h) - w(-h)) - (w(2 * h) - w(-2 * h))) / (12 * h);
    expect_relative(slope, power.at(strain_of(strain)).shape, 10 * accuracy, fmt::format("e = {}", strain));
  }
}

TEST_P(PowerShapes, DoNotJumpWhereTheExpansionsMeet) {
  const double below = power.at(strain_of(0.5)).measure;
  const double above = power.at(strain_of(std::nextafter(0.5, 1))).measure;
  EXPECT_NEAR(above, below, 1e-4 * accuracy * below);
}

TEST_P(PowerShapes, GrowWithStrain) {
  double before = 0;
  for (int i = 1; i <= 4000; ++i) {
    const double measure = power.at(with_gap(std::pow(10, -12.0 * i / 4000))).measure;
    ASSERT_GE(measure, before) << i;
    before = measure;
  }
}

INSTANTIATE_TEST_SUITE_P(Exponents, PowerShapes, testing::ValuesIn(exponents));

}  // namespace
}  // namespace dashpad::test
