/// Which row has which factors: counts, order, strata, moments, correlation, cut-offs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>

#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study.hpp"
#include "sample_case.hpp"
#include "study/sampling.hpp"

namespace dashpad::study {
namespace {

using test::good_case;

const boost::math::normal standard_normal;

Factor factor(const std::string& key, Spread spread) {
  return {.key = key, .unit = "m/s", .spread = std::move(spread), .lowest = {}, .highest = {}};
}

/// Uniform from 1 to 2, so that the fraction is the value less 1.
Factor fraction_of(const std::string& key) { return factor(key, Uniform{1, 2}); }

Study study_with(std::vector<Factor> factors, std::uint64_t samples = 1,
                 Sampling sampling = Sampling::monte_carlo) {
  Study study;
  study.base = test::read(good_case).impact;
  study.factors = std::move(factors);
  study.samples = samples;
  study.sampling = sampling;
  study.responses = {"peak_force"};
  return study;
}

std::vector<double> row_of(const Design& design, std::uint64_t row, std::size_t factors) {
  std::vector<double> values(factors);
  design.factors_of(row, values);
  return values;
}

/// One factor in all rows.
std::vector<double> column(const Study& study, std::size_t which = 0) {
  const Design design(study);
  std::vector<double> values;
  for (std::uint64_t row = 0; row < design.rows(); ++row)
    values.push_back(row_of(design, row, study.factors.size())[which]);
  return values;
}

struct Moments {
  double mean = 0, variance = 0, mean_error = 0, variance_error = 0;
};

Moments moments(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  Moments of;
  of.mean = std::accumulate(values.begin(), values.end(), 0.) / n;
  double second = 0, fourth = 0;
  for (const double value : values) {
    const double square = std::pow(value - of.mean, 2);
    second += square / n;
    fourth += square * square / n;
  }
  of.variance = second;
  of.mean_error = std::sqrt(second / n);
  of.variance_error = std::sqrt((fourth - second * second) / n);
  return of;
}

void expect_moments(const Factor& factor, double mean, double variance) {
  const Moments found = moments(column(study_with({factor}, 100'000)));
  EXPECT_NEAR(found.mean, mean, 5 * found.mean_error);
  EXPECT_NEAR(found.variance, variance, 5 * found.variance_error);
}

double correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const Moments of_x = moments(x), of_y = moments(y);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - of_x.mean) * (y[i] - of_y.mean);
  return sum / static_cast<double>(x.size()) / std::sqrt(of_x.variance * of_y.variance);
}

/// The known answers of Random123 1.09 (kat_vectors, philox4x32 10).
TEST(random_words, are_those_of_philox) {
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(random_words(0, 0, 0, Purpose{0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(random_words(~0ULL, ~0ULL, ~0U, Purpose{~0U}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(random_words(0x299f31d0a4093822, 0x85a308d3243f6a88, 0x13198a2e, Purpose{0x03707344}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(permutation, holds_every_number_once) {
  for (const std::uint64_t count : {1U, 2U, 3U, 4U, 5U, 7U, 16U, 17U, 100U, 1000U, 65537U}) {
    const Permutation permutation(count, 42, 0);
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < count; ++i) seen.insert(permutation.at(i));
    EXPECT_EQ(seen.size(), count);
    EXPECT_EQ(*seen.rbegin(), count - 1);
  }
}

/// Chi squared of where each number goes, over many seeds; 49 counts less their sums have 36 degrees of
/// freedom, of which 5 standard deviations are 36 + 5 sqrt(72).
TEST(permutation, prefers_no_place) {
  constexpr int count = 7, seeds = 7000;
  double found[count][count] = {};
  for (int seed = 0; seed < seeds; ++seed) {
    const Permutation permutation(count, static_cast<std::uint64_t>(seed), 3);
    for (std::uint64_t i = 0; i < count; ++i) ++found[i][permutation.at(i)];
  }
  double chi_squared = 0;
  for (const auto& row : found)
    for (const double value : row)
      chi_squared += std::pow(value - 1. * seeds / count, 2) / (1. * seeds / count);
  EXPECT_LT(chi_squared, 36 + 5 * std::sqrt(72));
}

TEST(sobol, has_the_points_of_boost) {
  constexpr std::size_t dimensions = 40, points = 256;
  const Sobol sobol(dimensions, 1);
  boost::random::sobol_engine<std::uint32_t, 32> engine(dimensions);
  std::set<std::vector<std::uint32_t>> ours, theirs{std::vector<std::uint32_t>(dimensions, 0)};
  for (std::size_t i = 0; i < points; ++i) {
    std::vector<std::uint32_t> point, of_boost;
    for (std::size_t k = 0; k < dimensions; ++k) point.push_back(sobol.plain(i, k));
    ours.insert(point);
    if (i == 0) continue;
    for (std::size_t k = 0; k < dimensions; ++k) of_boost.push_back(engine());
    theirs.insert(of_boost);
  }
  EXPECT_EQ(ours, theirs);
}

/// A point is anywhere with the same probability, and its places in two dimensions have nothing to do with
/// each other.
TEST(sobol, is_scrambled_evenly) {
  std::vector<double> first, second;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const Sobol sobol(2, seed);
    first.push_back(sobol.at(5, 0));
    second.push_back(sobol.at(5, 1));
  }
  for (const auto& values : {first, second}) {
    const Moments of = moments(values);
    EXPECT_NEAR(of.mean, 0.5, 5 * of.mean_error);
    EXPECT_NEAR(of.variance, 1. / 12, 5 * of.variance_error);
  }
  EXPECT_LT(std::abs(correlation(first, second)), 5 / std::sqrt(4000));
}

TEST(design, counts_levels_times_draws_times_blocks) {
  Study study = study_with({factor("impactor.speed", Levels{{1, 2, 3}}), fraction_of("impactor.radius"),
                            factor("pad.thickness", Levels{{0.01, 0.02}}), fraction_of("impactor.mass")},
                           5);
  EXPECT_EQ(Design(study).rows(), 3u * 2 * 5);
  study.indices = true;
  const Design design(study);
  EXPECT_EQ(design.rows(), 3u * 2 * 5 * 4);
  EXPECT_EQ(design.block_of(0), 0);
  EXPECT_EQ(design.block_of(7), 3);
  EXPECT_EQ(design.draw_of(7), 1u);
  EXPECT_EQ(design.draw_of(20), 0u);
  EXPECT_THROW(row_of(design, design.rows(), 4), std::out_of_range);
  EXPECT_THROW(row_of(design, 0, 3), std::out_of_range);
}

TEST(design, changes_the_last_level_first) {
  const Study study = study_with(
      {factor("impactor.speed", Levels{{1, 2, 3}}), factor("pad.thickness", Levels{{0.01, 0.02}})});
  const Design design(study);
  ASSERT_EQ(design.rows(), 6u);
  EXPECT_EQ(row_of(design, 0, 2), (std::vector{1, 0.01}));
  EXPECT_EQ(row_of(design, 1, 2), (std::vector{1, 0.02}));
  EXPECT_EQ(row_of(design, 2, 2), (std::vector{2, 0.01}));
  EXPECT_EQ(row_of(design, 5, 2), (std::vector{3, 0.02}));
}

TEST(design, draws_the_same_at_each_combination) {
  const Study study =
      study_with({factor("impactor.speed", Levels{{1, 2}}), fraction_of("impactor.mass")}, 10);
  const Design design(study);
  for (std::uint64_t draw = 0; draw < 10; ++draw)
    EXPECT_EQ(row_of(design, draw, 2)[1], row_of(design, 10 + draw, 2)[1]);
}

TEST(design, exchanges_one_factor_a_block) {
  Study study = study_with(
      {fraction_of("impactor.speed"), fraction_of("impactor.radius"), fraction_of("impactor.mass")}, 20);
  study.indices = true;
  for (const Sampling sampling : {Sampling::monte_carlo, Sampling::latin_hypercube, Sampling::sobol}) {
    study.sampling = sampling;
    const Design design(study);
    for (std::uint64_t draw = 0; draw < 20; ++draw) {
      const auto a = row_of(design, 5 * draw, 3), b = row_of(design, 5 * draw + 1, 3);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NE(a[i], b[i]);
        auto expected = a;
        expected[i] = b[i];
        EXPECT_EQ(row_of(design, 5 * draw + 2 + i, 3), expected);
      }
    }
  }
}

TEST(design, gives_the_same_row_in_any_order) {
  for (const Sampling sampling : {Sampling::monte_carlo, Sampling::latin_hypercube, Sampling::sobol}) {
    const Study study =
        study_with({fraction_of("impactor.speed"), fraction_of("impactor.mass")}, 300, sampling);
    const Design design(study), again(study);
    std::vector<std::vector<double>> rows(300);
    for (std::uint64_t row = 0; row < 300; ++row) rows[row] = row_of(design, row, 2);
    for (std::uint64_t row = 300; row-- > 0;) EXPECT_EQ(row_of(again, row * 7 % 300, 2), rows[row * 7 % 300]);
    Study other = study;
    other.seed = 2;
    const Design differing(other);
    for (std::uint64_t row = 0; row < 300; ++row) EXPECT_NE(row_of(differing, row, 2), rows[row]);
  }
}

TEST(design, has_one_point_in_each_stratum_of_a_latin_hypercube) {
  for (const std::uint64_t samples : {1U, 2U, 7U, 100U, 1000U}) {
    const Study study = study_with(
        {fraction_of("impactor.speed"), fraction_of("impactor.mass"), fraction_of("impactor.radius")},
        samples, Sampling::latin_hypercube);
    for (std::size_t which = 0; which < 3; ++which) {
      std::set<int> strata;
      for (const double value : column(study, which))
        strata.insert(static_cast<int>(std::floor((value - 1) * static_cast<double>(samples))));
      EXPECT_EQ(strata.size(), samples);
      EXPECT_EQ(*strata.begin(), 0);
      EXPECT_EQ(*strata.rbegin(), static_cast<int>(samples) - 1);
    }
  }
}

/// The first two dimensions are a (0, k, 2)-net in base 2, and the scrambling keeps it one.
TEST(design, has_one_sobol_point_in_each_elementary_interval) {
  for (const std::uint64_t seed : {1U, 2U, 3U})
    for (const int k : {1, 4, 8, 10}) {
      Study study = study_with({fraction_of("impactor.speed"), fraction_of("impactor.mass")}, 1ULL << k,
                               Sampling::sobol);
      study.seed = seed;
      const auto x = column(study, 0), y = column(study, 1);
      for (int a = 0; a <= k; ++a) {
        std::set<std::pair<int, int>> boxes;
        for (std::size_t i = 0; i < x.size(); ++i)
          boxes.emplace(static_cast<int>(std::ldexp(x[i] - 1, a)),
                        static_cast<int>(std::ldexp(y[i] - 1, k - a)));
        EXPECT_EQ(boxes.size(), x.size()) << "2^-" << a << " x 2^-" << k - a;
      }
    }
}

TEST(design, draws_each_distribution_with_its_moments) {
  expect_moments(factor("impactor.speed", Normal{10, 0.5}), 10, 0.25);
  const double spread = 0.3, median = 5;
  expect_moments(factor("impactor.speed", Lognormal{median, spread}), median * std::exp(spread * spread / 2),
                 median * median * std::exp(spread * spread) * std::expm1(spread * spread));
  expect_moments(factor("impactor.speed", Uniform{2, 5}), 3.5, 9. / 12);
  expect_moments(factor("impactor.speed", Triangular{1, 2, 6}), 3, (1. + 4 + 36 - 2 - 6 - 12) / 18);
  expect_moments(factor("impactor.speed", Triangular{1, 1, 4}), 2, (1. + 1 + 16 - 1 - 4 - 4) / 18);
  // Linear between 1, 2 and 5: half uniform from 1 to 2, half from 2 to 5.
  expect_moments(factor("impactor.speed", Empirical{{1, 2, 5}}), 2.5, 0.5 * (7. / 3 + 39. / 3) - 6.25);
}

TEST(design, gives_equal_measured_values_their_probability) {
  const auto values = column(study_with({factor("impactor.speed", Empirical{{1, 2, 2, 2, 3}})}, 100'000));
  const auto at_two = static_cast<double>(std::ranges::count(values, 2.));
  EXPECT_NEAR(at_two / 1e5, 0.5, 5 * std::sqrt(0.25 / 1e5));
}

TEST(design, cuts_off_and_makes_whole) {
  Factor cut = factor("impactor.speed", Normal{10, 1});
  cut.lowest = 10;
  cut.highest = 11;
  const double kept = cdf(standard_normal, 1) - 0.5;
  const double rise = (pdf(standard_normal, 0) - pdf(standard_normal, 1)) / kept;
  expect_moments(cut, 10 + rise, 1 - pdf(standard_normal, 1) / kept - rise * rise);
  const auto values = column(study_with({cut}, 10'000));
  EXPECT_GE(std::ranges::min(values), 10);
  EXPECT_LE(std::ranges::max(values), 11);
}

/// Far up the tail, where 1 - F has lost its digits: the mean is mu + sigma phi(a) / (1 - Phi(a)).
TEST(design, cuts_off_in_the_tail) {
  Factor cut = factor("impactor.speed", Normal{10, 1});
  cut.lowest = 14.5;
  const double expected = 10 + pdf(standard_normal, 4.5) / cdf(complement(standard_normal, 4.5));
  const Moments found = moments(column(study_with({cut}, 100'000)));
  EXPECT_NEAR(found.mean, expected, 5 * found.mean_error);
}

TEST(design, cuts_off_measured_values) {
  Factor cut = factor("impactor.speed", Empirical{{1, 2, 5}});
  cut.lowest = 1.5;
  cut.highest = 3.5;
  // A quarter of the probability on each side of 2.
  expect_moments(cut, 0.5 * 1.75 + 0.5 * 2.75,
                 0.5 * (1.75 * 1.75 + 0.25 / 12) + 0.5 * (2.75 * 2.75 + 2.25 / 12) - 2.25 * 2.25);
}

/// A value that was measured several times belongs to what is kept where it is the last one: of the lower
/// three quarters two thirds.
TEST(design, keeps_the_measured_value_at_which_it_is_cut_off) {
  Factor cut = factor("impactor.speed", Empirical{{1, 2, 2, 2, 3}});
  cut.highest = 2;
  const auto values = column(study_with({cut}, 100'000));
  EXPECT_NEAR(static_cast<double>(std::ranges::count(values, 2.)) / 1e5, 2. / 3, 5 * std::sqrt(2. / 9 / 1e5));
}

/// Six deviations out, and where the factor is cut off.
TEST(checked_range, ends_where_a_distribution_does) {
  const auto expect = [](Factor factor, double low, double high, bool has_tails) {
    const CheckedRange range = checked_range(factor);
    EXPECT_NEAR(range.low, low, 1e-12 * std::abs(low)) << factor.spread.index();
    EXPECT_NEAR(range.high, high, 1e-12 * std::abs(high)) << factor.spread.index();
    EXPECT_EQ(range.low_is_tail && range.high_is_tail, has_tails);
    factor.lowest = low + 0.1;
    factor.highest = high - 0.2;
    EXPECT_EQ(checked_range(factor).low, *factor.lowest);
    EXPECT_EQ(checked_range(factor).high, *factor.highest);
    EXPECT_FALSE(checked_range(factor).low_is_tail || checked_range(factor).high_is_tail);
  };
  expect(factor("impactor.speed", Normal{10, 1.5}), 1, 19, true);
  expect(factor("impactor.speed", Lognormal{10, 0.1}), 10 * std::exp(-0.6), 10 * std::exp(0.6), true);
  expect(factor("impactor.speed", Uniform{2, 5}), 2, 5, false);
  expect(factor("impactor.speed", Triangular{2, 3, 5}), 2, 5, false);
  expect(factor("impactor.speed", Empirical{{2, 3, 5}}), 2, 5, false);
}

TEST(design, correlates_as_asked) {
  Study study =
      study_with({factor("impactor.speed", Normal{10, 0.5}), factor("impactor.mass", Normal{5, 0.1}),
                  factor("impactor.radius", Normal{0.1, 0.01})},
                 100'000);
  study.correlations = {{0, 1, 0.4}, {2, 1, -0.7}};
  for (const Sampling sampling : {Sampling::monte_carlo, Sampling::latin_hypercube, Sampling::sobol}) {
    study.sampling = sampling;
    const auto x = column(study, 0), y = column(study, 1), z = column(study, 2);
    const double error = 5 / std::sqrt(1e5);
    EXPECT_NEAR(correlation(x, y), 0.4, error);
    EXPECT_NEAR(correlation(y, z), -0.7, error);
    EXPECT_NEAR(correlation(x, z), 0, error);
    EXPECT_NEAR(moments(y).variance, 0.01, 5 * moments(y).variance_error);
  }
}

/// None of the three is 0, and the third is not the product of the others, as in a chain.
TEST(design, correlates_three_factors_each_with_each) {
  Study study =
      study_with({factor("impactor.speed", Normal{10, 0.5}), factor("impactor.mass", Normal{5, 0.1}),
                  factor("impactor.radius", Normal{0.1, 0.01})},
                 100'000);
  study.correlations = {{0, 1, 0.6}, {0, 2, 0.6}, {1, 2, 0.1}};
  const auto x = column(study, 0), y = column(study, 1), z = column(study, 2);
  const double error = 5 / std::sqrt(1e5);
  EXPECT_NEAR(correlation(x, y), 0.6, error);
  EXPECT_NEAR(correlation(x, z), 0.6, error);
  EXPECT_NEAR(correlation(y, z), 0.1, error);
  EXPECT_NEAR(moments(z).variance, 1e-4, 5 * moments(z).variance_error);
}

TEST(design, draws_unrelated_factors_unrelated) {
  for (const Sampling sampling : {Sampling::monte_carlo, Sampling::latin_hypercube, Sampling::sobol}) {
    const Study study =
        study_with({fraction_of("impactor.speed"), fraction_of("impactor.mass")}, 20'000, sampling);
    EXPECT_LT(std::abs(correlation(column(study, 0), column(study, 1))), 5 / std::sqrt(2e4));
  }
}

TEST(design, refuses_a_bad_study) {
  EXPECT_THROW(Design(study_with({})), std::invalid_argument);
  EXPECT_THROW(Design(study_with({factor("impactor.speed", Levels{{}})})), std::invalid_argument);
  EXPECT_THROW(Design(study_with({factor("impactor.sped", Levels{{1}})})), std::invalid_argument);
}

TEST(application, writes_each_quantity) {
  Study study = study_with(
      {factor("impactor.weight", Levels{{9.80665 * 2}}), factor("impactor.radius", Levels{{0.1}}),
       factor("impactor.speed", Levels{{3}}), factor("pad.thickness", Levels{{0.05}}),
       factor("pad.parameters.relaxation_time", Levels{{0.02}}), factor("support.stiffness", Levels{{5e4}})});
  ImpactCase impact = study.base;
  Application{study}(row_of(Design(study), 0, 6), impact);
  EXPECT_DOUBLE_EQ(impact.impactor.mass, 2);
  EXPECT_EQ(std::get<Sphere>(impact.impactor.nose).radius, 0.1);
  EXPECT_EQ(impact.impactor.speed, 3);
  EXPECT_EQ(impact.pad.thickness, 0.05);
  EXPECT_EQ(std::get<NineParameter>(impact.pad.material.law).relaxation_time, 0.02);
  EXPECT_EQ(std::get<NineParameter>(impact.pad.material.law).rate_exponent,
            std::get<NineParameter>(study.base.pad.material.law).rate_exponent);
  EXPECT_DOUBLE_EQ(impact.support.force(0.01), 500);
}

TEST(application, scales_a_curve_and_chooses_a_material) {
  Study study = study_with({factor("support.scale", Levels{{1, 3}}), factor("pad.material", Levels{{0, 1}})});
  study.base.support = Support::through({{0.01, 100}, {0.02, 500}});
  study.materials = {study.base.pad.material, study.base.pad.material};
  study.materials[1].name = "other";
  study.materials[1].law = Elastic{1e6};
  const Design design(study);
  const Application application(study);
  ImpactCase impact = study.base;
  for (const std::uint64_t row : {3U, 0U, 3U}) {
    application(row_of(design, row, 2), impact);
    EXPECT_DOUBLE_EQ(impact.support.force(0.02), row == 3 ? 1500 : 500);
    EXPECT_EQ(std::holds_alternative<Elastic>(impact.pad.material.law), row == 3);
  }
}

TEST(worker, computes_batches_and_replays_their_rows) {
  const Study study = study_with({factor("impactor.speed", Levels{{1, 2, 3, 4, 5}})});
  const Design design(study);
  Worker worker(study, design), other(study, design);
  const auto last = worker.compute(2, 2);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].row, 4u);
  EXPECT_EQ(last[0].factors, std::vector<double>{5});
  Outcome outcome;
  EXPECT_EQ(*other.replay(4, outcome).summary.peak_force, last[0].outcome.values.at(0));
  EXPECT_EQ(outcome.values, last[0].outcome.values);
  EXPECT_TRUE(worker.compute(3, 2).empty());
  EXPECT_THROW(worker.replay(5, outcome), std::out_of_range);
}

/// The initial modulus must not be below the lasting one: at the middles and the ends it is not, but in some
/// rows.
TEST(worker, leaves_out_a_row_that_is_no_case) {
  Study study = study_with({factor("pad.parameters.asymptotic_modulus", Uniform{1e5, 3e5}),
                            factor("pad.parameters.initial_modulus", Uniform{2.1e5, 5e5})},
                           64, Sampling::sobol);
  study.base.pad.material.law = LinearViscoelastic{2e5, 3e5, 0.01};
  const Design design(study);
  Worker worker(study, design);
  int left_out = 0;
  for (const StoredRow& row : worker.compute(0, 64)) {
    const bool valid = row.factors[1] >= row.factors[0];
    EXPECT_EQ(row.outcome.status != Status::not_run, valid);
    EXPECT_EQ(std::isnan(row.outcome.values.at(0)), !valid);
    left_out += valid ? 0 : 1;
    if (!valid) {
      Outcome outcome;
      EXPECT_THROW(worker.replay(row.row, outcome), std::invalid_argument);
    }
  }
  EXPECT_GT(left_out, 0);
}

}  // namespace
}  // namespace dashpad::study
