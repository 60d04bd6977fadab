#include "dashpad/study/answers.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/binomial.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "dashpad/quantities/constants.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::study {
namespace {

using Binomial = boost::math::binomial_distribution<>;

constexpr double tail = 0.025;  // probability beyond each end of a 95 % interval
constexpr double probabilities[] = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

std::vector<double> sorted_values(std::span<const double> values) {
  std::vector<double> present;
  for (const double value : values)
    if (!std::isnan(value)) present.push_back(value);
  std::ranges::sort(present);
  return present;
}

/// Computes the moments in two passes; the mean of the first keeps the squares small. `values` are finite.
void set_moments(Distribution& distribution, const std::vector<double>& values, bool drawn) {
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value / count;
  double squares = 0, rest = 0;
  for (const double value : values) {
    squares += (value - sum) * (value - sum);
    rest += value - sum;
  }
  const double mean = sum + rest / count;
  distribution.mean = {mean, no_value, no_value};
  distribution.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1)) : no_value;
  if (!drawn || values.size() < 2) return;
  const double half = uncertainty::student_95(count - 1) * distribution.deviation / std::sqrt(count);
  distribution.mean.low = mean - half;
  distribution.mean.high = mean + half;
}

/// The least k with P(at most k of `count`) >= `share`.
std::uint64_t min_count(const Binomial& binomial, double share) {
  auto k = static_cast<std::uint64_t>(boost::math::quantile(binomial, share));  // within one of it
  while (k > 0 && cdf(binomial, static_cast<double>(k - 1)) >= share) --k;
  while (cdf(binomial, static_cast<double>(k)) < share) ++k;
  return k;
}

/// The distribution-free interval of a quantile between order statistics (David and Nagaraja, Order
/// Statistics, section 7.1). `values` are sorted.
Estimate quantile_of(const std::vector<double>& values, double probability, bool drawn) {
  const std::size_t count = values.size();
  const auto rank = static_cast<std::size_t>(std::ceil(probability * static_cast<double>(count)));
  Estimate estimate{values[std::clamp<std::size_t>(rank, 1, count) - 1], no_value, no_value};
  if (!drawn) return estimate;
  const Binomial binomial{static_cast<double>(count), probability};
  const std::uint64_t low = min_count(binomial, tail), high = min_count(binomial, 1 - tail) + 1;
  estimate.low = low == 0 ? -infinite : values[low - 1];
  estimate.high = infinite;
  if (high <= count) estimate.high = values[high - 1];
  return estimate;
}

double lower_bound(std::uint64_t count, std::uint64_t successes) {
  return Binomial::find_lower_bound_on_p(static_cast<double>(count), static_cast<double>(successes), tail);
}

double upper_bound(std::uint64_t count, std::uint64_t successes) {
  return Binomial::find_upper_bound_on_p(static_cast<double>(count), static_cast<double>(successes), tail);
}

/// Sums over draws, from which all indices follow.
struct Sums {
  double values = 0, squares = 0;  ///< sums over a and b
  std::vector<double> first, total;
  explicit Sums(std::size_t factors) : first(factors), total(factors) {}

  void add(const SaltelliSample& sample, double centre, std::size_t draw) {
    const double a = sample.a[draw] - centre, b = sample.b[draw] - centre;
    values += a + b;
    squares += a * a + b * b;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const double mixed = sample.mixed[i][draw] - centre;
      first[i] += (b - mixed) * (b - mixed);
      total[i] += (a - mixed) * (a - mixed);
    }
  }

  /// All first-order indices, then all total ones; 0 if nothing varies.
  [[nodiscard]] std::vector<double> indices(std::size_t draws) const {
    const auto count = static_cast<double>(draws);
    const double mean = values / (2 * count);
    const double variance = squares / (2 * count) - mean * mean;
    std::vector<double> result;
    for (const double sum : first) result.push_back(variance > 0 ? 1 - sum / (2 * count * variance) : 0);
    for (const double sum : total) result.push_back(variance > 0 ? sum / (2 * count * variance) : 0);
    return result;
  }
};

/// Enough for a standard error within a few per cent, fewer where draws are many.
std::size_t resamples(std::size_t draws, std::size_t factors) {
  return std::clamp<std::size_t>(300'000'000 / (draws * (factors + 1)), 100, 1000);
}

std::vector<double> standard_errors(const SaltelliSample& sample, double centre, std::uint64_t seed) {
  const std::size_t draws = sample.a.size(), factors = sample.mixed.size();
  const std::size_t count = resamples(draws, factors);
  boost::random::mt19937_64 generator{seed};
  const boost::random::uniform_int_distribution<std::size_t> pick{0, draws - 1};
  std::vector<double> sums(2 * factors), squares(2 * factors), first;
  for (std::size_t round = 0; round < count; ++round) {
    Sums of{factors};
    for (std::size_t n = 0; n < draws; ++n) of.add(sample, centre, pick(generator));
    const std::vector<double> indices = of.indices(draws);
    if (round == 0) first = indices;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const double difference = indices[i] - first[i];
      sums[i] += difference;
      squares[i] += difference * difference;
    }
  }
  const auto rounds = static_cast<double>(count);
  std::vector<double> errors;
  for (std::size_t i = 0; i < sums.size(); ++i)
    errors.push_back(std::sqrt(std::max(0.0, squares[i] - sums[i] * sums[i] / rounds) / (rounds - 1)));
  return errors;
}

Estimate estimate(double value, double standard_error) {
  return {value, value - 1.96 * standard_error, value + 1.96 * standard_error};
}

}  // namespace

std::optional<Estimate> quantile(const Distribution& distribution, double probability) {
  const auto found =
      std::ranges::find(distribution.quantiles, probability, &Distribution::Quantile::probability);
  if (found == distribution.quantiles.end() || std::isnan(found->value.value)) return {};
  return found->value;
}

Distribution distribution(std::span<const double> values, bool drawn) {
  const std::vector<double> present = sorted_values(values);
  Distribution of;
  of.struck_through = static_cast<std::uint64_t>(std::ranges::count(present, infinite));
  of.rows = present.size() - of.struck_through;
  of.without = values.size() - present.size();
  of.mean = {no_value, no_value, no_value};
  of.deviation = of.least = of.greatest = no_value;
  if (present.empty()) {
    for (const double probability : probabilities)
      of.quantiles.push_back({probability, {no_value, no_value, no_value}});
    return of;
  }
  of.least = present.front();
  of.greatest = present.back();
  if (of.struck_through == 0) set_moments(of, present, drawn);
  for (const double probability : probabilities)
    of.quantiles.push_back({probability, quantile_of(present, probability, drawn)});
  return of;
}

Exceedance exceedance(std::span<const Reading> rows, double limit, bool drawn) {
  Exceedance of;
  of.limit = limit;
  for (const Reading& row : rows) {
    if (row.low > limit)
      ++of.exceeding;
    else if (!(row.high <= limit))
      ++of.undecided;
    if (row.low == infinite) ++of.struck_through;
  }
  const std::uint64_t all = rows.size(), most = of.exceeding + of.undecided;
  of.rows = all - of.undecided;
  of.probability = {no_value, no_value, no_value};
  if (of.rows > 0) of.probability.value = static_cast<double>(of.exceeding) / static_cast<double>(of.rows);
  if (all == 0 || (!drawn && of.undecided == 0)) return of;
  const auto share = [&](std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(all);
  };
  of.probability.low = drawn ? lower_bound(all, of.exceeding) : share(of.exceeding);
  of.probability.high = drawn ? upper_bound(all, most) : share(most);
  return of;
}

std::vector<Sensitivity::Index> jansen_indices(const SaltelliSample& sample, std::uint64_t bootstrap_seed) {
  const std::size_t draws = sample.a.size(), factors = sample.mixed.size();
  const bool fits = sample.b.size() == draws && std::ranges::all_of(sample.mixed, [&](const auto& values) {
                      return values.size() == draws;
                    });
  if (draws < 2 || !fits)
    throw std::invalid_argument("indices need at least two draws, and the same number in each matrix");
  Sums mean{0};
  for (std::size_t n = 0; n < draws; ++n) mean.add(sample, 0, n);
  const double centre = mean.values / (2 * static_cast<double>(draws));
  Sums sums{factors};
  for (std::size_t n = 0; n < draws; ++n) sums.add(sample, centre, n);
  const std::vector<double> values = sums.indices(draws);
  const std::vector<double> errors = standard_errors(sample, centre, bootstrap_seed);
  std::vector<Sensitivity::Index> result;
  for (std::size_t i = 0; i < factors; ++i)
    result.push_back({.factor = {},
                      .first = estimate(values[i], errors[i]),
                      .total = estimate(values[factors + i], errors[factors + i])});
  return result;
}

std::optional<Sensitivity> sensitivity(const Study& study, const Design& design, const Records& records,
                                       std::size_t combination, std::size_t response) {
  if (!study.indices) return std::nullopt;
  std::vector<std::string> names;
  for (const Factor& factor : study.factors)
    if (factor.is_sampled()) names.push_back(factor.key);
  const std::size_t blocks = 2 + names.size();
  const std::uint64_t begin = combination * study.samples * blocks;

  // The rows of a draw stand one after the other; NaN where one is missing.
  std::vector<double> values(study.samples * blocks, std::numeric_limits<double>::quiet_NaN());
  const auto first = std::ranges::lower_bound(records.rows, begin);
  for (auto place = static_cast<std::size_t>(first - records.rows.begin()); place < records.rows.size();
       ++place) {
    const std::uint64_t row = records.rows[place];
    if (row - begin >= values.size()) break;
    const std::uint64_t draw = (row - begin) / blocks;
    values[draw * blocks + static_cast<std::size_t>(design.block_of(row))] =
        records.responses[response][place];
  }
  SaltelliSample sample;
  sample.mixed.resize(names.size());
  for (std::uint64_t draw = 0; draw < study.samples; ++draw) {
    const std::span of = std::span{values}.subspan(draw * blocks, blocks);
    if (std::ranges::any_of(of, [](double value) { return std::isnan(value); })) continue;
    sample.a.push_back(of[0]);
    sample.b.push_back(of[1]);
    for (std::size_t i = 0; i < names.size(); ++i) sample.mixed[i].push_back(of[2 + i]);
  }
  if (sample.a.size() < 2) return std::nullopt;
  Sensitivity result{.indices = jansen_indices(sample, study.seed),
                     .draws = sample.a.size(),
                     .left_out = study.samples - sample.a.size()};
  for (std::size_t i = 0; i < names.size(); ++i) result.indices[i].factor = names[i];
  return result;
}

}  // namespace dashpad::study
