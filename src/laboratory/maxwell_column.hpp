#pragma once
/// A column of viscoelastic foam on its way through a history (theory.md, Eq. 40): the lasting stress is
/// exact, each branch an integral over the arc.
///
///   q(x) = q(0) exp(-x / tau) + integral of g p'(e) de/dt exp(-(x - y) / tau) dy

#include <algorithm>
#include <array>
#include <cmath>

#include "laboratory/column.hpp"
#include "model/pad/column_law.hpp"

namespace dashpad::laboratory {

class MaxwellColumn {
 public:
  explicit MaxwellColumn(const ViscoelasticFoam& law) : law_(law), power_(law.exponents()) {}

  /// In tension the column is left, and follows the platen without force until it presses again.
  Contact enter(const Arc& arc) {
    arc_ = arc;
    return pressing_part(arc, lost_, [this](double x) { return stress(x).value > 0; });
  }

  /// `x` s after the arc's start.
  [[nodiscard]] WithError at(double x) const {
    const WithError found = stress(x);
    return {std::max(found.value, 0.0), found.error};
  }

  /// p.
  [[nodiscard]] double lasting(double strain) const {
    return strain > 0 ? envelope(law_, power_, strain_of(strain), {}, strain) : 0;
  }
  /// q of the first (0) or second (1) branch, `x` s after the arc's start.
  [[nodiscard]] WithError branch(int i, double x) const;

  /// Goes through an arc at once; the stress at its end. In place of enter(), at() and leave().
  [[nodiscard]] double pass(const Arc& arc) {
    arc_ = arc;
    leave();
    const double strain = arc.end.strain;
    return strain > 0 ? std::max(lasting(strain) + branches_[0].value + branches_[1].value, 0.0) : 0;
  }

  void leave() { branches_ = {branch(0, arc_.duration), branch(1, arc_.duration)}; }

 private:
  [[nodiscard]] WithError stress(double x) const {
    const WithError first = branch(0, x);
    const WithError second = branch(1, x);
    const double strain = arc_.at(x).strain;
    const double value = strain > 0 ? lasting(strain) + first.value + second.value : 0;
    return {value, first.error + second.error + 4e-16 * std::abs(value)};
  }

  ViscoelasticFoam law_;
  PowerShape power_;
  Arc arc_;
  std::array<WithError, 2> branches_{};
  bool lost_ = false;
};

inline WithError MaxwellColumn::branch(int i, double x) const {
  const double share = i == 0 ? law_.first_share : law_.second_share;
  const double time = i == 0 ? law_.first_time : law_.second_time;
  const WithError before = branches_[static_cast<std::size_t>(i)];
  const double kept = std::exp(-x / time);
  if (share == 0 || x == 0 || arc_.direction() == 0) return {before.value * kept, before.error * kept};
  const auto added = [&](double y) {
    const Motion motion = arc_.at(y);
    if (motion.strain <= 0)
      return 2 * (law_.first_modulus + law_.second_modulus) * motion.rate * share * std::exp((y - x) / time);
    const double slope = envelope_slope(law_, power_, strain_of(motion.strain), {}, motion.strain);
    return share * slope * motion.rate * std::exp((y - x) / time);
  };
  // Older parts than 40 relaxation times are gone.
  const WithError sum = integral(added, std::max(0.0, x - 40 * time), x, 1e-10, 10);
  return {before.value * kept + sum.value, before.error * kept + sum.error};
}

}  // namespace dashpad::laboratory
