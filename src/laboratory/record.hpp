#pragma once
/// The record of a material test while it is written.

#include <algorithm>
#include <utility>

#include "dashpad/laboratory/column_test.hpp"
#include "laboratory/arc.hpp"
#include "laboratory/quadrature.hpp"

namespace dashpad::laboratory {

class Record {
 public:
  void add(double time, Motion motion, WithError stress) {
    test_.time.push_back(time);
    test_.strain.push_back(motion.strain);
    test_.rate.push_back(motion.rate);
    test_.stress.push_back(std::max(stress.value, 0.0));
    test_.work.push_back(work_.value);
    largest_error_ = std::max(largest_error_, stress.error);
  }
  /// Done since the last place.
  void work(WithError done) {
    work_.value += done.value;
    work_.error += done.error;
  }
  void note(ColumnEvent::Kind kind, double time, double strain, double before, double after) {
    test_.events.push_back({kind, time, strain, before, after});
  }
  [[nodiscard]] double stress() const { return test_.stress.back(); }

  ColumnTest finished() {
    test_.largest_strain = *std::max_element(test_.strain.begin(), test_.strain.end());
    const double peak = *std::max_element(test_.stress.begin(), test_.stress.end());
    test_.stress_error = peak > 0 ? largest_error_ / peak : 0;
    test_.work_error = work_.error;
    return std::move(test_);
  }

 private:
  ColumnTest test_;
  WithError work_;
  double largest_error_ = 0;
};

}  // namespace dashpad::laboratory
