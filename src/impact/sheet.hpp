#pragma once
/// A sheet with mass but neither stiffness nor tension on the struck face: a rubber cover, a steel trim.
///
///   (M + m) dV/dt = M g - F - D,   m = mu a,   D = (dm/dt) (dY/dt) on the way in         (theory.md, Eq. 56)
///
/// A column's share of it is at rest with the pad until the nose meets it, is taken along in a plastic blow,
/// and keeps the speed that it has where the column is left without stress. Compression positive; SI units.

#include <algorithm>
#include <numbers>

#include "dashpad/model/nose/sections.hpp"

namespace dashpad {

class Sheet {
 public:
  /// No sheet.
  Sheet() = default;
  /// `mass_per_area`: mu, kg/m2, >= 0; 0: no sheet.
  Sheet(double mass_per_area, const Sections& nose) : mass_per_area_(mass_per_area), nose_(nose) {}

  [[nodiscard]] bool has_mass() const { return mass_per_area_ > 0; }
  /// Starts at first contact, as the tip has met its share.
  void start() {
    carried_ = mass_per_area_ * nose_.tip;
    loss_rate_ = 0;
  }
  /// m, mass that moves with the nose, kg.
  [[nodiscard]] double carried() const { return carried_; }

  /// Means of m, kg, and of D, N, over a step from one penetration to another.
  struct Load {
    double mass = 0;
    double drag = 0;
  };
  [[nodiscard]] Load load(double from, double to, double step) const {
    // Above the pad there is nothing to meet.
    from = std::max(from, 0.0);
    to = std::max(to, 0.0);
    if (to > from) {
      const double met = mass_per_area_ * (nose_.area(to) - nose_.area(from));
      return {carried_ + met / 2, met * (to - from) / (step * step)};
    }
    // On the way back the columns left are known only at the end of a step.
    return {to < from ? std::max(carried_ - loss_rate_ * step / 2, 0.0) : carried_, 0};
  }
  /// D at a penetration and its rate, N.
  [[nodiscard]] double drag(double penetration, double rate) const {
    if (rate <= 0) return 0;
    return mass_per_area_ * 2 * std::numbers::pi * nose_.rate(penetration) * rate * rate;
  }
  /// Accepts the end of a step; `radius` is that of the stressed area, m.
  void accept(double radius, bool goes_back, double step) {
    const double before = carried_;
    carried_ = mass_per_area_ * std::numbers::pi * radius * radius;
    loss_rate_ = goes_back ? std::max(before - carried_, 0.0) / step : 0;
  }

 private:
  double mass_per_area_ = 0;
  Sections nose_;
  double carried_ = 0;
  double loss_rate_ = 0;  ///< loss of m per time, kg/s
};

}  // namespace dashpad
