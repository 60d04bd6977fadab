#pragma once

namespace dashpad::injury {

/// A sum of doubles that keeps what rounding takes from it.
class AccurateSum {
 public:
  void add(double x) {
    const double sum = high_ + x;
    const double kept = sum - high_;
    low_ += (high_ - (sum - kept)) + (x - kept);
    high_ = sum;
  }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

}  // namespace dashpad::injury
