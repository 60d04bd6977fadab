#include "dashpad/study/answers.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>

#include "dashpad/quantities/constants.hpp"
#include "uncertainty/student.hpp"

namespace dashpad::study {

namespace {

using Binomial = boost::math::binomial_distribution<>;

constexpr double tail = 0.025;  // of a 95 % interval, at each end
constexpr double probabilities[] = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

std::vector<double> sorted_values(std::span<const double> values) {
  std::vector<double> present;
  for (const double value : values)
    if (!std::isnan(value)) present.push_back(value);
  std::ranges::sort(present);
  return present;
}

/// Two passes: the first one's mean keeps the squares small. `values` are finite.
void set_moments(Distribution& of, const std::vector<double>& values, bool drawn) {
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value / count;
  double squares = 0, rest = 0;
  for (const double value : values) {
    squares += (value - sum) * (value - sum);
    rest += value - sum;
  }
  const double mean = sum + rest / count;
  of.mean = {mean, no_value, no_value};
  of.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1)) : no_value;
  if (!drawn || values.size() < 2) return;
  const double half = uncertainty::student_95(count - 1) * of.deviation / std::sqrt(count);
  of.mean.low = mean - half;
  of.mean.high = mean + half;
}

/// The least k with P(at most k of `count`) >= `share`.
std::uint64_t least_count(const Binomial& binomial, double share) {
  auto k = static_cast<std::uint64_t>(boost::math::quantile(binomial, share));  // within one of it
  while (k > 0 && cdf(binomial, static_cast<double>(k - 1)) >= share) --k;
  while (cdf(binomial, static_cast<double>(k)) < share) ++k;
  return k;
}

/// The quantile lies below order statistic j with P(fewer than j values below it) and so on: David and
/// Nagaraja, Order Statistics, section 7.1. `values` are sorted.
Estimate quantile_of(const std::vector<double>& values, double probability, bool drawn) {
  const std::size_t count = values.size();
  const auto rank = static_cast<std::size_t>(std::ceil(probability * static_cast<double>(count)));
  Estimate estimate{values[std::clamp<std::size_t>(rank, 1, count) - 1], no_value, no_value};
  if (!drawn) return estimate;
  const Binomial binomial{static_cast<double>(count), probability};
  const std::uint64_t low = least_count(binomial, tail), high = least_count(binomial, 1 - tail) + 1;
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

}  // namespace

std::optional<Estimate> quantile(const Distribution& of, double probability) {
  const auto found = std::ranges::find(of.quantiles, probability, &Distribution::Quantile::probability);
  if (found == of.quantiles.end() || std::isnan(found->value.value)) return {};
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

}  // namespace dashpad::study
