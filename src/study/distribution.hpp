#pragma once
/// Values of a sampled factor from fractions of its probability.

#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "dashpad/study/study.hpp"
#include "study/empirical.hpp"

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>

namespace dashpad::study {

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

}  // namespace dashpad::study
