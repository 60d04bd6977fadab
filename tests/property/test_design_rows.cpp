/// A study of many factors: every row is finite, within its cut-offs, and makes a case.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dashpad/study/study.hpp"

namespace dashpad::study {
namespace {

Study many_factors(Sampling sampling) {
  const auto factor = [](const char* key, Spread spread, std::optional<double> lowest = {},
                         std::optional<double> highest = {}) {
    return Factor{.key = key, .unit = "", .spread = std::move(spread), .lowest = lowest, .highest = highest};
  };
  Study study;
  study.base.impactor = {.mass = 4, .nose = Sphere{0.1}, .speed = 8};
  study.base.pad.thickness = 0.02;
  study.base.pad.material.law = LinearViscoelastic{1e5, 1e6, 0.01};
  study.base.support = Support::linear(1e5);
  study.factors = {factor("impactor.speed", Normal{8, 3}, 0.5),
                   factor("impactor.mass", Lognormal{4, 0.5}),
                   factor("impactor.radius", Uniform{0.05, 0.2}),
                   factor("pad.thickness", Triangular{0.01, 0.02, 0.05}),
                   factor("support.stiffness", Lognormal{1e5, 1}, 1e3, 1e7),
                   factor("pad.parameters.relaxation_time", Empirical{{0.001, 0.002, 0.002, 0.05}}),
                   factor("pad.parameters.asymptotic_modulus", Levels{{1e5, 2e5}})};
  study.correlations = {{0, 1, 0.3}, {1, 2, 0.5}, {3, 4, -0.6}};
  study.samples = 50'000;
  study.sampling = sampling;
  study.responses = {"peak_force"};
  return study;
}

TEST(design_rows, are_finite_cases_within_their_cut_offs) {
  for (const Sampling sampling : {Sampling::monte_carlo, Sampling::latin_hypercube, Sampling::sobol}) {
    const Study study = many_factors(sampling);
    const Design design(study);
    const Application application(study);
    ASSERT_EQ(design.rows(), 100'000u);
    std::vector<double> values(study.factors.size());
    ImpactCase impact = study.base;
    std::uint64_t bad = 0;
    for (std::uint64_t row = 0; row < design.rows(); ++row) {
      design.factors_of(row, values);
      application(values, impact);
      const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
      const bool within =
          values[0] >= 0.5 && values[4] >= 1e3 && values[4] <= 1e7 && values[3] >= 0.01 && values[3] <= 0.05;
      if (!finite || !within || !violations(impact).empty()) ++bad;
    }
    EXPECT_EQ(bad, 0u);
  }
}

}  // namespace
}  // namespace dashpad::study
