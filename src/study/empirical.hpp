#pragma once
/// The distribution of measured values: linear between them.

#include <algorithm>
#include <cmath>
#include <vector>

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

}  // namespace dashpad::study
