// Statistics of studies against closed forms and against what their intervals promise.

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "dashpad/study/answers.hpp"

namespace dashpad::study {
namespace {

using std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Values that are known; NaN is not.
std::vector<Reading> readings(const std::vector<double>& values) {
  std::vector<Reading> list;
  for (const double value : values)
    list.push_back(std::isnan(value) ? Reading{-infinity, infinity} : Reading{value, value});
  return list;
}

/// Independent uniform numbers in [low, high).
using Row = std::vector<double>;
using Model = std::function<double(const Row&)>;

SaltelliSample sample_of(const Model& model, std::size_t factors, double low, double high, std::size_t draws,
                         unsigned seed) {
  std::mt19937_64 generator{seed};
  const auto uniform = [&] {
    return low + (high - low) * static_cast<double>(generator() >> 11) * std::ldexp(1.0, -53);
  };
  SaltelliSample sample;
  sample.mixed.resize(factors);
  for (std::size_t n = 0; n < draws; ++n) {
    Row a, b;
    for (std::size_t i = 0; i < factors; ++i) a.push_back(uniform()), b.push_back(uniform());
    sample.a.push_back(model(a));
    sample.b.push_back(model(b));
    for (std::size_t i = 0; i < factors; ++i) {
      Row mixed = a;
      mixed[i] = b[i];
      sample.mixed[i].push_back(model(mixed));
    }
  }
  return sample;
}

/// Ishigami and Homma 1990 with a = 7, b = 0.1, all factors uniform on [-pi, pi].
double ishigami(const Row& x) {
  return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

struct Closed {
  double first[3], total[3];
};

/// The variances of its parts in closed form.
Closed ishigami_indices() {
  const double v1 = 0.5 * std::pow(1 + 0.1 * std::pow(pi, 4) / 5, 2), v2 = 49.0 / 8;
  const double v13 = 0.01 * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50), v = v1 + v2 + v13;
  return {{v1 / v, v2 / v, 0}, {(v1 + v13) / v, v2 / v, v13 / v}};
}

TEST(StudyAnswersVerification, TheClosedFormOfIshigamiIsThePublishedOne) {
  const Closed closed = ishigami_indices();
  EXPECT_NEAR(closed.first[0], 0.3139, 5e-5);
  EXPECT_NEAR(closed.first[1], 0.4424, 5e-5);
  EXPECT_NEAR(closed.total[0], 0.5576, 5e-5);
  EXPECT_NEAR(closed.total[2], 0.2437, 5e-5);
}

TEST(StudyAnswersVerification, IndicesOfIshigami) {
  const Closed closed = ishigami_indices();
  const auto indices = jansen_indices(sample_of(ishigami, 3, -pi, pi, 40'000, 1), 5);
  ASSERT_EQ(indices.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(indices[i].first.value, closed.first[i], 0.02) << i;
    EXPECT_NEAR(indices[i].total.value, closed.total[i], 0.015) << i;
    EXPECT_LT(indices[i].first.high - indices[i].first.low, 0.06) << i;
  }
}

/// The intervals of 300 studies hold the true index in about 95 % of them: between 91 and 98.5 %, which a
/// coverage of 95 % misses once in thousands.
TEST(StudyAnswersVerification, IntervalsOfIndicesCover) {
  const Closed closed = ishigami_indices();
  constexpr int studies = 300;
  int first[3] = {}, total[3] = {};
  for (unsigned seed = 1; seed <= studies; ++seed) {
    const auto indices = jansen_indices(sample_of(ishigami, 3, -pi, pi, 500, seed), seed);
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] += indices[i].first.low <= closed.first[i] && closed.first[i] <= indices[i].first.high;
      total[i] += indices[i].total.low <= closed.total[i] && closed.total[i] <= indices[i].total.high;
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (const int covered : {first[i], total[i]}) {
      EXPECT_GE(covered, 0.91 * studies) << i;
      EXPECT_LE(covered, 0.985 * studies) << i;
    }
}

/// Without interactions first-order and total indices are the same: the squares of the coefficients.
TEST(StudyAnswersVerification, IndicesOfASum) {
  const Model sum = [](const Row& x) { return 100 + 3 * x[0] + 2 * x[1] + x[2]; };
  const auto indices = jansen_indices(sample_of(sum, 4, 0, 1, 40'000, 2), 5);
  const double exact[] = {9.0 / 14, 4.0 / 14, 1.0 / 14, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(indices[i].first.value, exact[i], 0.02) << i;
    EXPECT_NEAR(indices[i].total.value, exact[i], 0.01) << i;
  }
  EXPECT_EQ(indices[3].total.value, 0) << "a factor that does nothing";
}

TEST(StudyAnswersVerification, ALargeMeanCostsNoDigits) {
  const auto shifted = [](double by) {
    return jansen_indices(sample_of([by](const Row& x) { return by + ishigami(x); }, 3, -pi, pi, 1000, 3),
                          5)[0]
        .first.value;
  };
  EXPECT_NEAR(shifted(1e8), shifted(0), 1e-6);
}

TEST(StudyAnswersVerification, NothingVaries) {
  for (const auto& index : jansen_indices(sample_of([](const Row&) { return 4; }, 2, 0, 1, 100, 4), 5)) {
    EXPECT_EQ(index.first.value, 0);
    EXPECT_EQ(index.total.value, 0);
  }
}

/// Clopper and Pearson: at least 95 % by construction; the sum over all outcomes is exact, nothing is drawn.
TEST(StudyAnswersVerification, ClopperPearsonCovers) {
  constexpr int rows = 60;
  for (const double truth : {0.003, 0.05, 0.3, 0.5, 0.9}) {
    double coverage = 0, outcome = std::pow(1 - truth, rows);  // binomial probability of k
    for (int k = 0; k <= rows; ++k) {
      std::vector<double> values(rows, 0);
      std::fill_n(values.begin(), k, 2);
      const Exceedance of = exceedance(readings(values), 1);
      EXPECT_EQ(of.exceeding, static_cast<std::uint64_t>(k));
      if (of.probability.low <= truth && truth <= of.probability.high) coverage += outcome;
      outcome *= static_cast<double>(rows - k) / (k + 1) * truth / (1 - truth);
    }
    EXPECT_GE(coverage, 0.95) << truth;
    EXPECT_LE(coverage, 1 + 1e-12) << truth;
  }
}

/// Tabulated: 10 rows, none above; 1 - 0.025^(1/10) = 0.30850.
TEST(StudyAnswersVerification, NoneAboveTheLimit) {
  const Exceedance of = exceedance(readings(std::vector<double>(10, 0)), 1);
  EXPECT_EQ(of.probability.value, 0);
  EXPECT_EQ(of.probability.low, 0);
  EXPECT_NEAR(of.probability.high, 1 - std::pow(0.025, 0.1), 1e-12);
}

TEST(StudyAnswersVerification, UndecidedRowsWidenTheInterval) {
  std::vector<double> values(20, 0);
  values[0] = 2;
  values[1] = nan;
  const Exceedance of = exceedance(readings(values), 1);
  EXPECT_EQ(of.undecided, 1U);
  EXPECT_EQ(of.rows, 19U);
  EXPECT_DOUBLE_EQ(of.probability.value, 1.0 / 19);
  values[1] = 0;
  EXPECT_EQ(of.probability.low, exceedance(readings(values), 1).probability.low);
  values[1] = 2;
  EXPECT_EQ(of.probability.high, exceedance(readings(values), 1).probability.high);
}

/// 3 of 10 bottomed out on a rigid support: 30 % above any limit, by Clopper and Pearson from 6.67 to 65.25
/// %, whatever the limit.
TEST(StudyAnswersVerification, RowsThatStruckThroughAreAboveEveryLimit) {
  std::vector<double> values(10, 1);
  for (const std::size_t i : {2U, 5U, 9U}) values[i] = infinity;
  const Exceedance of = exceedance(readings(values), 1e300);
  EXPECT_EQ(of.struck_through, 3U);
  EXPECT_EQ(of.exceeding, 3U);
  EXPECT_EQ(of.undecided, 0U);
  EXPECT_DOUBLE_EQ(of.probability.value, 0.3);
  EXPECT_NEAR(of.probability.low, 0.06674, 5e-6);
  EXPECT_NEAR(of.probability.high, 0.65245, 5e-6);
  EXPECT_TRUE(std::isnan(exceedance(readings(values), 2, false).probability.low)) << "a grid decides all";
}

TEST(StudyAnswersVerification, LowerBoundsDecideALimitThatTheyExceed) {
  const std::vector<Reading> rows{{5, infinity}, {1, 1}, {1, 1}, {1, 1}};
  const Exceedance above = exceedance(rows, 4), open = exceedance(rows, 6);
  EXPECT_EQ(above.exceeding, 1U);
  EXPECT_EQ(above.undecided, 0U);
  EXPECT_EQ(above.struck_through, 0U);
  EXPECT_EQ(open.exceeding, 0U);
  EXPECT_EQ(open.undecided, 1U);
  const Exceedance grid = exceedance(rows, 6, false);
  EXPECT_EQ(grid.probability.low, 0);
  EXPECT_EQ(grid.probability.high, 0.25) << "both readings of the undecided row";
}

/// At one thickness the response is the speed, at the other the mass.
TEST(StudyAnswersVerification, IndicesAreThoseOfTheirCombinationOfLevels) {
  Study study;
  study.base.impactor = {.mass = 5, .nose = Sphere{0.08}, .speed = 1};
  study.base.pad.thickness = 0.05;
  study.base.pad.material.law = Elastic{.modulus = 3e5};
  study.factors = {{.key = "pad.thickness", .unit = "m", .spread = Levels{{0.04, 0.05, 0.06}}},
                   {.key = "impactor.speed", .unit = "m/s", .spread = Uniform{1, 2}},
                   {.key = "impactor.mass", .unit = "kg", .spread = Uniform{4, 6}}};
  study.samples = 200;
  study.indices = true;
  study.responses = {"peak_force"};
  const Design design(study);
  Records records;
  records.responses.resize(1);
  for (std::uint64_t row = 0; row < design.rows(); ++row) {
    Row factors(3);
    design.factors_of(row, factors);
    records.rows.push_back(row);
    records.statuses.push_back(Status::released);
    records.responses[0].push_back(factors[0] == 0.06 ? factors[2] : factors[1]);
  }
  for (const std::size_t combination : {0U, 1U, 2U}) {
    const Sensitivity of = sensitivity(study, design, records, combination, 0).value();
    EXPECT_EQ(of.draws, 200U);
    EXPECT_EQ(of.left_out, 0U);
    const std::size_t all = combination == 2 ? 1 : 0;
    EXPECT_NEAR(of.indices[all].total.value, 1, 0.2) << combination;
    EXPECT_NEAR(of.indices[1 - all].total.value, 0, 1e-12) << combination;
    EXPECT_EQ(of.indices[all].factor, all == 0 ? "impactor.speed" : "impactor.mass");
  }
}

TEST(StudyAnswersVerification, AValueIsKnownWhereTheImpactWentToItsEnd) {
  Study study;
  study.responses = {"peak_force", "rebound_speed"};
  Records records;
  records.statuses = {Status::released, Status::at_rest, Status::time_limit, Status::tolerance_not_met,
                      Status::bottomed_out};
  records.responses.assign(2, {1, 2, 3, 4, 5});
  const Group group{.levels = {}, .places = {0, 1, 2, 3, 4}};
  // A force is known, or a lower bound at the time limit, or beyond all bounds; a speed grows with nothing.
  const double low[2][5]{{1, 2, 3, -infinity, infinity}, {1, 2, -infinity, -infinity, 5}};
  const double high[2][5]{{1, 2, infinity, infinity, infinity}, {1, 2, infinity, infinity, 5}};
  for (std::size_t response = 0; response < 2; ++response) {
    const std::vector<Reading> found = readings_of(study, records, group, response);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(found.at(i).low, low[response][i]) << response << ", " << i;
      EXPECT_EQ(found.at(i).high, high[response][i]) << response << ", " << i;
    }
  }
}

/// Ten rows, four of them bottomed out on a rigid support: the median is the 5th of ten, the 95 % quantile
/// has no bound.
TEST(StudyAnswersVerification, RowsThatStruckThroughAreAboveAllInQuantiles) {
  const std::vector<double> values{3, infinity, 1, 2, infinity, 4, infinity, 5, 6, infinity};
  const Distribution of = distribution(values);
  EXPECT_EQ(of.rows, 6U);
  EXPECT_EQ(of.struck_through, 4U);
  EXPECT_EQ(of.without, 0U);
  EXPECT_EQ(of.quantiles[3].value.value, 5);
  EXPECT_EQ(of.quantiles[5].value.value, infinity);
  EXPECT_EQ(of.least, 1);
  EXPECT_EQ(of.greatest, infinity);
  EXPECT_TRUE(std::isnan(of.mean.value)) << "there is no mean of a value without bound";
  EXPECT_TRUE(std::isnan(of.deviation));
}

/// For each quantile of an exponential distribution, over 4000 samples of 50: at least 95 % (less three
/// standard errors), whatever the distribution, and exactly what the binomial distribution says for the
/// median.
TEST(StudyAnswersVerification, QuantileIntervalsCover) {
  constexpr int samples = 4000, rows = 50;
  std::mt19937_64 generator{11};
  int covered[7] = {};
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<double> values;
    for (int i = 0; i < rows; ++i)
      values.push_back(-std::log1p(-static_cast<double>(generator() >> 11) * std::ldexp(1.0, -53)));
    const Distribution of = distribution(values);
    for (std::size_t q = 0; q < 7; ++q) {
      const double truth = -std::log1p(-of.quantiles[q].probability);
      const Estimate& estimate = of.quantiles[q].value;
      EXPECT_LE(estimate.low, estimate.value);
      EXPECT_GE(estimate.high, estimate.value);
      covered[q] += estimate.low <= truth && truth <= estimate.high;
    }
  }
  for (std::size_t q = 0; q < 7; ++q)
    EXPECT_GE(covered[q], (0.95 - 3 * std::sqrt(0.05 * 0.95 / samples)) * samples) << q;
  // The median lies between the 18th and the 33rd of 50 values with probability 0.9672.
  EXPECT_NEAR(covered[3] / double{samples}, 0.9672, 3 * std::sqrt(0.0328 * 0.9672 / samples));
}

TEST(StudyAnswersVerification, MomentsAndOrderStatistics) {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(1e9 + (i * 37) % 101);  // 1 to 100 in another order
  values.push_back(nan);
  const Distribution of = distribution(values);
  EXPECT_EQ(of.rows, 100U);
  EXPECT_EQ(of.without, 1U);
  EXPECT_DOUBLE_EQ(of.mean.value, 1e9 + 50.5);
  EXPECT_NEAR(of.deviation, std::sqrt(100.0 * 101 / 12), 1e-9);
  EXPECT_NEAR(of.mean.high - of.mean.value, 1.98421695 * of.deviation / 10, 1e-6);  // Student, 99 degrees
  EXPECT_EQ(of.quantiles[3].value.value, 1e9 + 50);
  EXPECT_EQ(of.quantiles[0].value.low, -std::numeric_limits<double>::infinity())
      << "too few rows for a bound";
  EXPECT_TRUE(std::isnan(distribution(values, false).mean.low)) << "a grid has no intervals";
}

TEST(StudyAnswersVerification, EmptyAndSingle) {
  EXPECT_TRUE(std::isnan(distribution(std::vector<double>{}).mean.value));
  EXPECT_TRUE(std::isnan(exceedance({}, 1).probability.high));
  const Distribution of = distribution(std::vector<double>{3});
  EXPECT_EQ(of.mean.value, 3);
  EXPECT_TRUE(std::isnan(of.mean.low));
  EXPECT_EQ(of.quantiles[3].value.high, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace dashpad::study
