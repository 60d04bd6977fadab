#include "study/sampling.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"

namespace dashpad::study {
namespace {

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
double below(const EmpiricalDistribution& measured, double x) { return measured.below(x); }

template <class Distribution>
double up_to(const Distribution& distribution, double x) {
  return below(distribution, x);
}
double up_to(const EmpiricalDistribution& measured, double x) { return measured.up_to(x); }

template <class Distribution>
double above(const Distribution& distribution, double x) {
  return x == -infinite ? 1 : x == infinite ? 0 : cdf(complement(distribution, x));
}
double above(const EmpiricalDistribution& measured, double x) { return 1 - measured.up_to(x); }

template <class Distribution>
double value_at(const Distribution& distribution, double fraction, bool from_above) {
  return from_above ? quantile(complement(distribution, fraction)) : quantile(distribution, fraction);
}
double value_at(const EmpiricalDistribution& measured, double fraction, bool from_above) {
  return measured.quantile(from_above ? 1 - fraction : fraction);
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
std::string rule_for(const ByRow&) { return ""; }
std::string rule_for(const ByDraw&) { return ""; }
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
  if (empirical.values.size() < 2) return "there must be at least two measured values";
  if (!std::ranges::all_of(empirical.values, [](double value) { return std::isfinite(value); }))
    return "the measured values must be finite numbers";
  if (!std::ranges::is_sorted(empirical.values)) return "the measured values must be sorted";
  return empirical.values.front() < empirical.values.back() ? "" : "the measured values are all the same";
}

}  // namespace

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
                 [](const ByRow&) -> Any { throw std::invalid_argument("rows have no distribution"); },
                 [](const ByDraw& drawn) -> Any {
                   std::vector<double> sorted = drawn.values;
                   std::ranges::sort(sorted);
                   if (sorted.size() == 1) sorted.push_back(sorted.front());
                   return EmpiricalDistribution(std::move(sorted));
                 },
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
    return factor.lowest || factor.highest ? "lowest and highest apply only to a distribution" : "";
  const double lowest = factor.lowest.value_or(-infinite), highest = factor.highest.value_or(infinite);
  if (std::isnan(lowest) || std::isnan(highest)) return "lowest and highest must be finite numbers";
  if (!(lowest < highest)) return "lowest must be less than highest";
  constexpr double min_kept = 1e-6;
  const double kept = Quantiles(factor).kept();
  if (!(kept >= min_kept))
    return fmt::format("lowest and highest leave a probability of only {:.2g}; it must be at least {}", kept,
                       min_kept);
  return "";
}

CheckedRange checked_range(const Factor& factor) {
  constexpr double out = deviations_checked;
  CheckedRange range = std::visit(
      Overloaded{[]<class Given>
                   requires requires(const Given& given) { given.values;
}
(const Given& given) { return CheckedRange{std::ranges::min(given.values), std::ranges::max(given.values)}; }
,
    [](const Normal& normal) {
      return CheckedRange{normal.mean - out * normal.deviation, normal.mean + out * normal.deviation, true,
                          true};
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
    }
}  // namespace dashpad::study
,
      factor.spread);
if (factor.lowest && *factor.lowest > range.low) range.low = *factor.lowest, range.low_is_tail = false;
if (factor.highest && *factor.highest < range.high) range.high = *factor.highest, range.high_is_tail = false;
return range;
}

}  // namespace dashpad::study
