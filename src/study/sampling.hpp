#pragma once
/// Samples of the varied factors: random fractions, Latin hypercubes and Sobol points, distributions and
/// correlations, and checks of the resulting cases. Random numbers are Philox 4x32-10 of Random123 (Salmon,
/// Moraes, Dror, Shaw: SC11).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// The purpose of a random number; numbers for different purposes are independent.
enum class Purpose : std::uint32_t { draw, permutation, jitter, scrambling };

/// 128 random bits. `place` is the draw, `dimension` the factor.
std::array<std::uint32_t, 4> random_words(std::uint64_t seed, std::uint64_t place, std::uint32_t dimension,
                                          Purpose purpose);

/// A random number in (0, 1), at the middle of one of 2^53 equal intervals.
inline double random_fraction(std::uint64_t seed, std::uint64_t place, std::uint32_t dimension,
                              Purpose purpose) {
  const auto words = random_words(seed, place, dimension, purpose);
  const std::uint64_t bits = std::uint64_t{words[1]} << 32 | words[0];
  // The last middle would round to 1.
  const double fraction = (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
  return fraction < 1 ? fraction : 1 - 0x1p-53;
}

/// A random permutation by a keyed Feistel network on the least power of 4 not below `count`. Numbers outside
/// are mapped again (cycle walking: Black, Rogaway, CT-RSA 2002), fewer than four times on average.
class Permutation {
 public:
  /// `count` in [1, 2^62].
  Permutation(std::uint64_t count, std::uint64_t seed, std::uint32_t dimension);
  [[nodiscard]] std::uint64_t at(std::uint64_t number) const;

 private:
  static constexpr std::size_t rounds = 8;
  [[nodiscard]] std::uint64_t encrypted(std::uint64_t number) const;

  std::uint64_t count_;
  unsigned half_bits_ = 1;
  std::array<std::uint64_t, rounds> keys_{};
};

/// Direction numbers of Boost.Random (Joe, Kuo 2008). Owen's nested uniform scrambling by hashing: Laine,
/// Karras, Stratified sampling for stochastic transparency, EGSR 2011; Burley, Practical hash-based Owen
/// scrambling, JCGT 9(4), 2020. Each dimension has a seed of its own, from Philox.
class Sobol {
 public:
  static constexpr std::size_t max_dimensions = 1000;

  Sobol(std::size_t dimensions, std::uint64_t seed);
  /// A number in (0, 1), at the middle of one of 2^32 equal intervals; `number` is below 2^32.
  [[nodiscard]] double at(std::uint64_t number, std::size_t dimension) const;
  /// The point before scrambling, in units of 2^-32. Point 0 is 0 in all dimensions.
  [[nodiscard]] std::uint32_t plain(std::uint64_t number, std::size_t dimension) const;

 private:
  std::vector<std::array<std::uint32_t, 32>> directions_;  ///< direction numbers of each dimension
  std::vector<std::uint32_t> seeds_;
};

class FractionSource {
 public:
  FractionSource(const Study& study, std::size_t dimensions)
      : sampling_(study.sampling), seed_(study.seed), count_(study.samples) {
    if (sampling_ == Sampling::sobol && dimensions > 0) sobol_.emplace(dimensions, seed_);
    if (sampling_ == Sampling::latin_hypercube)
      for (std::uint32_t i = 0; i < dimensions; ++i) strata_.emplace_back(count_, seed_, i);
  }

  [[nodiscard]] double at(std::uint64_t draw, std::size_t dimension) const {
    const auto i = static_cast<std::uint32_t>(dimension);
    switch (sampling_) {
      case Sampling::sobol: return sobol_->at(draw, dimension);
      case Sampling::latin_hypercube: {
        const double within = random_fraction(seed_, draw, i, Purpose::jitter);
        const double place = static_cast<double>(strata_[dimension].at(draw)) + within;
        const double fraction = place / static_cast<double>(count_);
        return fraction < 1 ? fraction : 1 - 0x1p-53;
      }
      case Sampling::monte_carlo: break;
    }
    return random_fraction(seed_, draw, i, Purpose::draw);
  }

 private:
  Sampling sampling_;
  std::uint64_t seed_, count_;
  std::optional<Sobol> sobol_;
  std::vector<Permutation> strata_;
};

// Values of sampled factors, their correlations, and checks of the cases that they make.

/// The distribution with F(x(i)) = i / (n - 1) for values x(0) <= ... <= x(n - 1), n >= 2, and linear between
/// them. Equal values carry the probability between them.
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

/// Double precision throughout, and infinity instead of an exception for a probability of 0 or 1.
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
  /// Needs a sampled factor without violations.
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

/// The rule that the numbers of a distribution break, or "".
std::string rule_broken_by(const Factor& factor);

/// The range in which a distribution is checked: its ends or cut-offs, or 6 deviations of a normal one.
struct CheckedRange {
  double low = 0, high = 0;
  bool low_is_tail = false, high_is_tail = false;  ///< 6 deviations out: rarer values exist
};
CheckedRange checked_range(const Factor& factor);

using Matrix = std::vector<std::vector<double>>;

/// L with L L^T = C, the correlations of the sampled factors. Absent if C is not positive definite.
std::optional<Matrix> root_of_correlations(const Study& study);

}  // namespace dashpad::study
