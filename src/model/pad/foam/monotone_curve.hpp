#pragma once
/// The points of a table as a curve through the origin.

// Boost 1.74 uses isnan without a namespace.
#include <math.h>  // NOLINT(modernize-deprecated-headers)

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <vector>

#include "dashpad/model/pad/foam/table_curve.hpp"

namespace dashpad {

/// A monotone cubic between the points, continued as a line beyond the last. The table must be sound.
class MonotoneCurve {
 public:
  explicit MonotoneCurve(const TableCurve& table)
      : last_(table.strain.back()), curve_(with_origin(table.strain), with_origin(table.stress)) {
    last_stress_ = table.stress.back();
    last_slope_ = std::max(curve_.prime(last_), 0.0);
  }

  [[nodiscard]] double last_strain() const { return last_; }
  [[nodiscard]] double stress(double strain) const {
    if (strain >= last_) return last_stress_ + last_slope_ * (strain - last_);
    return curve_(std::max(strain, 0.0));
  }

 private:
  static std::vector<double> with_origin(const std::vector<double>& values) {
    std::vector<double> all{0};
    all.insert(all.end(), values.begin(), values.end());
    return all;
  }

  double last_ = 0;
  double last_stress_ = 0;
  double last_slope_ = 0;
  boost::math::interpolators::pchip<std::vector<double>> curve_;
};

}  // namespace dashpad
