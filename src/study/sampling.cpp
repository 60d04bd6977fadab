#include "study/sampling.hpp"

#include <bit>

#include <fmt/format.h>
#include <boost/random/sobol.hpp>

#include "dashpad/quantities/constants.hpp"

namespace dashpad::study {
namespace {

/// The finaliser of MurmurHash3 (Appleby): every bit of the result depends on every bit of the argument.
std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  x ^= x >> 33;
  return x;
}

using Engine = boost::random::sobol_engine<std::uint32_t, 32>;

/// All dimensions of point `number`, from 1; Boost leaves out point 0, which is 0.
std::vector<std::uint32_t> point(std::size_t dimensions, std::uint64_t number) {
  std::vector<std::uint32_t> values(dimensions, 0);
  if (number == 0) return values;
  Engine engine(dimensions);
  engine.discard((number - 1) * dimensions);
  for (std::uint32_t& value : values) value = engine();
  return values;
}

std::uint32_t reversed(std::uint32_t x) {
  x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
  x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
  x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
  x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
  return x << 16 | x >> 16;
}

/// Each bit is flipped or not by what the bits below it are: the other way round, Owen's scrambling.
std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

/// A smaller pivot is one factor that the others determine.
constexpr double min_pivot = 1e-10;

Matrix correlation_matrix(const Study& study) {
  const auto sampled = sampled_factors(study);
  const auto place = [&](std::size_t factor) {
    return static_cast<std::size_t>(std::ranges::find(sampled, factor) - sampled.begin());
  };
  Matrix matrix(sampled.size(), std::vector<double>(sampled.size(), 0.));
  for (std::size_t i = 0; i < sampled.size(); ++i) matrix[i][i] = 1;
  for (const Correlation& correlation : study.correlations) {
    const std::size_t i = place(correlation.first), j = place(correlation.second);
    if (i < sampled.size() && j < sampled.size()) matrix[i][j] = matrix[j][i] = correlation.value;
  }
  return matrix;
}

constexpr double deviations_checked = 6;

template <class... Case>
struct Overloaded : Case... {
  using Case::operator()...;
};
template <class... Case>
Overloaded(Case...) -> Overloaded<Case...>;

/// P(X < x); of the continuous ones P(X <= x) as well.
template <class Distribution>
double below(const Distribution& distribution, double x) {
  return x == -infinite ? 0 : x == infinite ? 1 : cdf(distribution, x);
}
double below(const EmpiricalDistribution& empirical_distribution, double x) {
  return empirical_distribution.below(x);
}

template <class Distribution>
double up_to(const Distribution& distribution, double x) {
  return below(distribution, x);
}
double up_to(const EmpiricalDistribution& empirical_distribution, double x) {
  return empirical_distribution.up_to(x);
}

template <class Distribution>
double above(const Distribution& distribution, double x) {
  return x == -infinite ? 1 : x == infinite ? 0 : cdf(complement(distribution, x));
}
double above(const EmpiricalDistribution& empirical_distribution, double x) {
  return 1 - empirical_distribution.up_to(x);
}

template <class Distribution>
double value_at(const Distribution& distribution, double fraction, bool from_above) {
  return from_above ? quantile(complement(distribution, fraction)) : quantile(distribution, fraction);
}
double value_at(const EmpiricalDistribution& empirical_distribution, double fraction, bool from_above) {
  return empirical_distribution.quantile(from_above ? 1 - fraction : fraction);
}

/// A lognormal has no probability at 0 and below, where Boost has no distribution function.
double lowest_of(const Factor& factor) {
  const double lowest = factor.lowest.value_or(-infinite);
  return std::holds_alternative<Lognormal>(factor.spread) ? std::max(lowest, 0.) : lowest;
}

bool all_finite(std::initializer_list<double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

std::string rule_for(const Levels&) { return ""; }
std::string rule_for(const Normal& normal) {
  if (!all_finite({normal.mean, normal.deviation})) return "mean and deviation must be finite numbers";
  return normal.deviation > 0 ? "" : "the deviation must be more than 0";
}
std::string rule_for(const Lognormal& lognormal) {
  if (!all_finite({lognormal.median, lognormal.spread})) return "median and spread must be finite numbers";
  if (!(lognormal.median > 0)) return "the median must be more than 0";
  return lognormal.spread > 0 && lognormal.spread <= 10 ? ""
                                                        : "the spread must be more than 0 and at most 10";
}
std::string rule_for(const Uniform& uniform) {
  if (!all_finite({uniform.low, uniform.high})) return "low and high must be finite numbers";
  return uniform.low < uniform.high ? "" : "low must be less than high";
}
std::string rule_for(const Triangular& triangular) {
  if (!all_finite({triangular.low, triangular.mode, triangular.high}))
    return "low, mode and high must be finite numbers";
  if (!(triangular.low < triangular.high)) return "low must be less than high";
  return triangular.low <= triangular.mode && triangular.mode <= triangular.high
             ? ""
             : "the mode must lie between low and high";
}
std::string rule_for(const Empirical& empirical) {
  if (empirical.values.size() < 2) return "needs two measured values or more";
  if (!std::ranges::all_of(empirical.values, [](double value) { return std::isfinite(value); }))
    return "the measured values must be finite numbers";
  if (!std::ranges::is_sorted(empirical.values)) return "the measured values must be sorted";
  return empirical.values.front() < empirical.values.back() ? "" : "the measured values are all the same";
}

}  // namespace

Permutation::Permutation(std::uint64_t count, std::uint64_t seed, std::uint32_t dimension) : count_(count) {
  while (half_bits_ < 31 && (std::uint64_t{1} << (2 * half_bits_)) < count) ++half_bits_;
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto words = random_words(seed, round, dimension, Purpose::permutation);
    keys_[round] = std::uint64_t{words[1]} << 32 | words[0];
  }
}

std::uint64_t Permutation::encrypted(std::uint64_t number) const {
  const std::uint64_t mask = (std::uint64_t{1} << half_bits_) - 1;
  std::uint64_t left = number >> half_bits_, right = number & mask;
  for (const std::uint64_t key : keys_) {
    const std::uint64_t next = left ^ (mixed(right ^ key) & mask);
    left = right;
    right = next;
  }
  return left << half_bits_ | right;
}

std::uint64_t Permutation::at(std::uint64_t number) const {
  do number = encrypted(number);
  while (number >= count_);
  return number;
}

/// Boost goes through the points in the order of the Gray code: from point 2^j - 1 to point 2^j only
/// direction j changes.
Sobol::Sobol(std::size_t dimensions, std::uint64_t seed) : directions_(dimensions), seeds_(dimensions) {
  for (unsigned j = 0; j < 32; ++j) {
    const auto before = point(dimensions, (std::uint64_t{1} << j) - 1);
    const auto after = point(dimensions, std::uint64_t{1} << j);
    for (std::size_t i = 0; i < dimensions; ++i) directions_[i][j] = before[i] ^ after[i];
  }
  for (std::size_t i = 0; i < dimensions; ++i)
    seeds_[i] = random_words(seed, 0, static_cast<std::uint32_t>(i), Purpose::scrambling)[0];
}

std::uint32_t Sobol::plain(std::uint64_t number, std::size_t dimension) const {
  std::uint32_t value = 0;
  for (; number != 0; number &= number - 1)
    value ^= directions_[dimension][static_cast<std::size_t>(std::countr_zero(number))];
  return value;
}

double Sobol::at(std::uint64_t number, std::size_t dimension) const {
  const std::uint32_t scrambled =
      reversed(laine_karras(reversed(plain(number, dimension)), seeds_[dimension]));
  return (scrambled + 0.5) * 0x1p-32;
}

std::vector<std::size_t> sampled_factors(const Study& study) {
  std::vector<std::size_t> sampled;
  for (std::size_t i = 0; i < study.factors.size(); ++i)
    if (study.factors[i].is_sampled()) sampled.push_back(i);
  return sampled;
}

std::optional<Matrix> root_of_correlations(const Study& study) {
  const Matrix matrix = correlation_matrix(study);
  Matrix root(matrix.size(), std::vector<double>(matrix.size(), 0.));
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) rest -= root[i][k] * root[j][k];
      if (i == j && !(rest > min_pivot)) return std::nullopt;
      root[i][j] = i == j ? std::sqrt(rest) : rest / root[j][j];
    }
  return root;
}

Quantiles::Any Quantiles::made_of(const Spread& spread) {
  return std::visit(
      Overloaded{[](const Levels&) -> Any { throw std::invalid_argument("levels have no distribution"); },
                 [](const Normal& normal) -> Any {
                   return boost::math::normal_distribution<double, Policy>(normal.mean, normal.deviation);
                 },
                 [](const Lognormal& lognormal) -> Any {
                   return boost::math::lognormal_distribution<double, Policy>(std::log(lognormal.median),
                                                                              lognormal.spread);
                 },
                 [](const Uniform& uniform) -> Any {
                   return boost::math::uniform_distribution<double, Policy>(uniform.low, uniform.high);
                 },
                 [](const Triangular& triangular) -> Any {
                   return boost::math::triangular_distribution<double, Policy>(
                       triangular.low, triangular.mode, triangular.high);
                 },
                 [](const Empirical& empirical) -> Any { return EmpiricalDistribution(empirical.values); }},
      spread);
}

Quantiles::Quantiles(const Factor& factor)
    : distribution_(made_of(factor.spread)),
      lowest_(lowest_of(factor)),
      highest_(factor.highest.value_or(infinite)) {
  std::visit(
      [this](const auto& given) {
        from_above_ = below(given, lowest_) > 0.5;
        begin_ = from_above_ ? above(given, highest_) : below(given, lowest_);
        width_ = from_above_ ? above(given, lowest_) - begin_ : up_to(given, highest_) - begin_;
      },
      distribution_);
}

double Quantiles::at(double fraction) const {
  const double within = from_above_ ? 1 - fraction : fraction;
  const double value =
      std::visit([&](const auto& given) { return value_at(given, begin_ + within * width_, from_above_); },
                 distribution_);
  return std::clamp(value, lowest_, highest_);
}

std::string rule_broken_by(const Factor& factor) {
  std::string rule = std::visit([](const auto& given) { return rule_for(given); }, factor.spread);
  if (!rule.empty()) return rule;
  if (!factor.is_sampled())
    return factor.lowest || factor.highest ? "only a distribution can be cut off by lowest and highest" : "";
  const double lowest = factor.lowest.value_or(-infinite), highest = factor.highest.value_or(infinite);
  if (std::isnan(lowest) || std::isnan(highest)) return "lowest and highest must be finite numbers";
  if (!(lowest < highest)) return "lowest must be less than highest";
  constexpr double min_kept = 1e-6;
  const double kept = Quantiles(factor).kept();
  if (!(kept >= min_kept))
    return fmt::format("lowest and highest leave a probability of {:.2g}; it must be at least {}", kept,
                       min_kept);
  return "";
}

CheckedRange checked_range(const Factor& factor) {
  constexpr double out = deviations_checked;
  CheckedRange range = std::visit(
      Overloaded{[](const Levels& levels) {
                   return CheckedRange{std::ranges::min(levels.values), std::ranges::max(levels.values)};
                 },
                 [](const Normal& normal) {
                   return CheckedRange{normal.mean - out * normal.deviation,
                                       normal.mean + out * normal.deviation, true, true};
                 },
                 [](const Lognormal& lognormal) {
                   return CheckedRange{lognormal.median * std::exp(-out * lognormal.spread),
                                       lognormal.median * std::exp(out * lognormal.spread), true, true};
                 },
                 [](const Uniform& uniform) {
                   return CheckedRange{uniform.low, uniform.high};
                 },
                 [](const Triangular& triangular) {
                   return CheckedRange{triangular.low, triangular.high};
                 },
                 [](const Empirical& empirical) {
                   return CheckedRange{empirical.values.front(), empirical.values.back()};
                 }},
      factor.spread);
  if (factor.lowest && *factor.lowest > range.low) range.low = *factor.lowest, range.low_is_tail = false;
  if (factor.highest && *factor.highest < range.high)
    range.high = *factor.highest, range.high_is_tail = false;
  return range;
}

}  // namespace dashpad::study
