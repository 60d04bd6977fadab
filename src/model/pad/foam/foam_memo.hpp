#pragma once
/// Cache of the tables of foams. Making them takes most of the time of a short test, and varying the numbers
/// of a law one after the other needs most of them again.

#include <deque>

#include "dashpad/model/pad/foam.hpp"
#include "model/pad/foam/cell_table.hpp"
#include "model/pad/foam/foam_curve.hpp"

namespace dashpad {

/// Holds the latest tables, for one thread; results are the same as without it.
class FoamMemo {
 public:
  /// The prepared curve, valid until the next call.
  const FoamCurve& curve(const BaseCurve& base, double continuation_exponent) {
    for (const KnownCurve& known : curves_)
      if (known.exponent == continuation_exponent && known.base == base) return known.curve;
    if (curves_.size() == most) curves_.pop_back();
    curves_.push_front({base, continuation_exponent, FoamCurve(base, continuation_exponent)});
    return curves_.front().curve;
  }

  /// The table of the way back with these two numbers, made by `make` if new. Valid until the next call.
  template <class Make>
  const CellTable& way_back(double factor, double shape, Make&& make) {
    for (const KnownWayBack& known : ways_back_)
      if (known.factor == factor && known.shape == shape) return known.table;
    if (ways_back_.size() == most) ways_back_.pop_back();
    ways_back_.push_front({factor, shape, make()});
    return ways_back_.front().table;
  }

 private:
  /// Room for central differences by fifteen numbers, and the values between.
  static constexpr std::size_t most = 32;
  struct KnownCurve {
    BaseCurve base;
    double exponent;
    FoamCurve curve;
  };
  struct KnownWayBack {
    double factor, shape;
    CellTable table;
  };
  std::deque<KnownCurve> curves_;
  std::deque<KnownWayBack> ways_back_;
};

}  // namespace dashpad
