/// The three kinds of sampling against an integral that is known.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {
namespace {

constexpr std::size_t dimensions = 5;
constexpr int seeds = 200;

/// Five factors, uniform from 1 to 2.
Study five_factors(Sampling sampling, std::uint64_t samples) {
  Study study;
  study.base.impactor = {.mass = 1, .nose = Sphere{1}, .speed = 1};
  study.base.pad.thickness = 1;
  study.base.pad.material.law = LinearViscoelastic{1, 10, 1};
  study.base.support = Support::linear(1);
  for (const char* key :
       {"impactor.mass", "impactor.radius", "impactor.speed", "pad.thickness", "support.stiffness"})
    study.factors.push_back({.key = key, .unit = "", .spread = Uniform{1, 2}, .lowest = {}, .highest = {}});
  study.sampling = sampling;
  study.samples = samples;
  study.responses = {"peak_force"};
  return study;
}

/// The mean of the product of 1 + (u - 1/2) over the factors, which is 1; its variance is (1 + 1/12)^5 - 1.
double estimate(const Design& design) {
  std::vector<double> values(dimensions);
  double sum = 0;
  for (std::uint64_t row = 0; row < design.rows(); ++row) {
    design.factors_of(row, values);
    double product = 1;
    for (const double value : values) product *= value - 0.5;
    sum += product;
  }
  return sum / static_cast<double>(design.rows());
}

struct Scatter {
  double bias = 0, deviation = 0;
};

Scatter scatter(Sampling sampling, std::uint64_t samples) {
  Study study = five_factors(sampling, samples);
  double sum = 0, squares = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    study.seed = static_cast<std::uint64_t>(seed);
    const double error = estimate(Design(study)) - 1;
    sum += error;
    squares += error * error;
  }
  return {sum / seeds, std::sqrt(squares / seeds)};
}

const double deviation = std::sqrt(std::pow(1 + 1. / 12, 5) - 1);

/// The deviation of Monte Carlo is known, and 200 seeds find it to within 5 / sqrt(400) of itself.
TEST(sampling, of_monte_carlo_scatters_as_it_must) {
  const double expected = deviation / std::sqrt(1024);
  const Scatter found = scatter(Sampling::monte_carlo, 1024);
  EXPECT_NEAR(found.bias, 0, 5 * expected / std::sqrt(seeds));
  EXPECT_NEAR(found.deviation, expected, 0.25 * expected);
}

/// A Latin hypercube takes away what the factors do one by one: of the variance 1.0833^5 - 1, 5/12 (McKay,
/// Beckman, Conover 1979; Stein 1987).
TEST(sampling, of_latin_hypercubes_leaves_the_interactions) {
  const double expected = std::sqrt((deviation * deviation - 5. / 12) / 1024);
  const Scatter found = scatter(Sampling::latin_hypercube, 1024);
  EXPECT_NEAR(found.bias, 0, 5 * expected / std::sqrt(seeds));
  EXPECT_NEAR(found.deviation, expected, 0.25 * expected);
}

/// Owen 1997: the estimate is unbiased, and for a smooth function its deviation falls as N^-1.5 (log N)^2 in
/// five dimensions: from 256 to 4096 points by the order 1.5 - 2 log(12/8) / log(16) = 1.21.
TEST(sampling, of_sobol_points_converges_fast) {
  const Scatter coarse = scatter(Sampling::sobol, 256), fine = scatter(Sampling::sobol, 4096);
  EXPECT_NEAR(coarse.bias, 0, 5 * coarse.deviation / std::sqrt(seeds));
  EXPECT_NEAR(fine.bias, 0, 5 * fine.deviation / std::sqrt(seeds));
  EXPECT_LT(coarse.deviation, 0.2 * deviation / std::sqrt(256));
  const double order = std::log(coarse.deviation / fine.deviation) / std::log(16);
  EXPECT_NEAR(order, 1.21, 0.15);
}

}  // namespace
}  // namespace dashpad::study
