#pragma once
/// A column without memory on its way through a history: its stress is a curve of the strain, on which a law
/// that does not recover only is while its strain grows beyond the largest, or is held there.

#include <algorithm>
#include <cmath>

#include "dashpad/model/pad/law.hpp"
#include "laboratory/column.hpp"

namespace dashpad::laboratory {

template <IsMemoryless Law>
class CurveColumn {
 public:
  explicit CurveColumn(const Law& law) : curve_(law.curve()) {}

  Contact enter(const Arc& arc) {
    arc_ = arc;
    const int direction = arc.direction();
    Contact contact{false, 0, arc.duration, false, false};
    if (!Law::recovers && direction < 0) {
      contact.lost = !lost_;
      contact.to = 0;
    } else if (direction > 0) {
      contact.from = Law::recovers ? 0 : passing();
      contact.any = contact.from < arc.duration;
      contact.taken_up = contact.any && lost_;
    } else {
      contact.any = !lost_;
      contact.lost = direction < 0 && arc.end.strain == 0 && !lost_;
    }
    lost_ = contact.lost || (lost_ && !contact.any);
    from_ = contact.from;
    return contact;
  }

  [[nodiscard]] WithError at(double x) const {
    // Where the strain begins to grow from zero, the curve's jump is past.
    const double strain = arc_.at(x).strain;
    const bool grows_from_zero = x == from_ && strain == 0 && arc_.direction() > 0;
    const double stress = grows_from_zero ? curve_.initial_stress : curve_.at(strain);
    return {stress, 4e-16 * stress};
  }

  void leave() { largest_ = std::max(largest_, arc_.end.strain); }

 private:
  /// When the strain passes the largest so far: the root of the parabola without cancellation.
  [[nodiscard]] double passing() const {
    const double rise = largest_ - arc_.start.strain;
    if (rise <= 0) return 0;
    if (arc_.end.strain <= largest_) return arc_.duration;
    const double rate = arc_.start.rate;
    const double root = std::sqrt(std::max(rate * rate + 2 * arc_.acceleration * rise, 0.0));
    return std::min(2 * rise / (rate + root), arc_.duration);
  }

  StressCurve curve_;
  Arc arc_;
  double from_ = 0;
  double largest_ = 0;
  bool lost_ = false;
};

}  // namespace dashpad::laboratory
