#pragma once
/// Values of sampled factors from fractions of their probability, their correlations, and whether the values
/// of all factors make cases that can be solved.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// F(x(i)) = i / (n - 1) for the values x(0) <= ... <= x(n - 1), n >= 2; linear between. Equal values carry
/// the probability between them.
class EmpiricalDistribution {
 public:
  explicit EmpiricalDistribution(std::vector<double> sorted) : values_(std::move(sorted)) {}

  [[nodiscard]] double quantile(double fraction) const {
    const double place = fraction * static_cast<double>(values_.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), values_.size() - 2);
    return std::lerp(values_[below], values_[below + 1], place - static_cast<double>(below));
  }
  /// P(X < x) and P(X <= x).
  [[nodiscard]] double below(double x) const { return at(std::ranges::lower_bound(values_, x), x); }
  [[nodiscard]] double up_to(double x) const { return at(std::ranges::upper_bound(values_, x), x); }

 private:
  [[nodiscard]] double at(std::vector<double>::const_iterator after, double x) const {
    if (after == values_.begin()) return 0;
    if (after == values_.end()) return 1;
    const double low = *(after - 1), high = *after;
    const double part = high > low ? (x - low) / (high - low) : 0;
    return (static_cast<double>(after - values_.begin() - 1) + part) /
           static_cast<double>(values_.size() - 1);
  }

  std::vector<double> values_;
};

/// In double precision throughout; infinity instead of an exception for a probability of 0 or 1.
using Policy =
    boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                  boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;
using StandardNormal = boost::math::normal_distribution<double, Policy>;

/// The inverse distribution function of a factor, cut off at its `lowest` and `highest`:
///
///   x(u) = F^-1(F(lowest) + u (F(highest) - F(lowest)))
///
/// taken from above where the median is below `lowest`, for accuracy in the tail.
class Quantiles {
 public:
  /// Of a sampled factor without violations.
  explicit Quantiles(const Factor& factor);
  [[nodiscard]] double at(double fraction) const;
  /// The probability between the cut-offs before they were made.
  [[nodiscard]] double kept() const { return width_; }

 private:
  using Any = std::variant<boost::math::normal_distribution<double, Policy>,
                           boost::math::lognormal_distribution<double, Policy>,
                           boost::math::uniform_distribution<double, Policy>,
                           boost::math::triangular_distribution<double, Policy>, EmpiricalDistribution>;
  static Any made_of(const Spread& spread);

  Any distribution_;
  double lowest_, highest_;
  bool from_above_ = false;
  double begin_ = 0, width_ = 1;  ///< probability up to the lower cut-off (above the upper one) and between
};

/// What is wrong with the numbers of a distribution, or "".
std::string rule_broken_by(const Factor& factor);

/// The range in which a distribution is checked before work starts: its ends or cut-offs, and 6 deviations of
/// a normal where it has none.
struct CheckedRange {
  double low = 0, high = 0;
  bool low_is_tail = false, high_is_tail = false;  ///< 6 deviations out: rarer values exist
};
CheckedRange checked_range(const Factor& factor);

using Matrix = std::vector<std::vector<double>>;

/// L with L L^T = C, where C has the study's correlations between its sampled factors, in their order. Absent
/// where C is not positive definite.
std::optional<Matrix> root_of_correlations(const Study& study);

/// The indices of the sampled factors.
std::vector<std::size_t> sampled_factors(const Study& study);

/// Rules of the case that levels or the ends of distributions break, under keys such as
/// "factors.impactor.speed". All combinations of levels are tried, up to 100,000; with more, each level with
/// the first of the others. The sampled factors stand at their medians, and at each end of their range (6
/// deviations out for a normal that is not cut off) one at a time. For a study whose factors are sound in
/// themselves.
std::vector<Violation> case_violations(const Study& study);

}  // namespace dashpad::study
