#pragma once
/// Tables of foams that were made ready before. To make them takes most of the time of a short test, and
/// whoever varies one number of a law after the other needs most of them again.

#include <deque>

#include "dashpad/model/pad/foam.hpp"
#include "model/pad/foam/cell_table.hpp"
#include "model/pad/foam/foam_curve.hpp"

namespace dashpad {

/// For one thread. Holds the latest few; what it gives is what would be made.
class FoamMemo {
 public:
  /// Valid until the next call.
  const FoamCurve& curve(const BaseCurve& base, double continuation_exponent) {
    for (const KnownCurve& known : curves_)
      if (known.exponent == continuation_exponent && known.base == base) return known.curve;
    if (curves_.size() == most) curves_.pop_back();
    curves_.push_front({base, continuation_exponent, FoamCurve(base, continuation_exponent)});
    return curves_.front().curve;
  }

  /// The table of the way back with these two numbers, which `make` makes. Valid until the next call.
  template <class Make>
  const CellTable& way_back(double factor, double shape, Make&& make) {
    for (const KnownWayBack& known : ways_back_)
      if (known.factor == factor && known.shape == shape) return known.table;
    if (ways_back_.size() == most) ways_back_.pop_back();
    ways_back_.push_front({factor, shape, make()});
    return ways_back_.front().table;
  }

 private:
  /// Central differences by fifteen numbers, and the place between.
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
