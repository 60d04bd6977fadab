#pragma once
/// Columns of foams and of laws without memory, led through a history arc by arc: enter() an arc, ask for
/// stresses at() times within it, leave() it.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dashpad/model/pad/law.hpp"
#include "laboratory/arc.hpp"
#include "model/pad/column_law.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad::laboratory {

/// A column of foam (theory.md, Eqs. 32 to 38).
///
/// The slip follows an arc of constant rate exactly; a parabola is cut into pieces, and the error is
/// estimated with pieces of twice the length. The stress is a function of strain and slip, so the column
/// presses wherever that is above 0, also on reloading.
class FoamColumn {
 public:
  template <SharesSlip Law>
  explicit FoamColumn(const Law& law) : law_(law) {}
  FoamColumn(const Foam& law, FoamMemo* memo) : law_(law, memo) {}

  Contact enter(const Arc& arc) {
    arc_ = arc;
    fine_ = slips_along(arc, arc.acceleration == 0 ? 1 : pieces, fine_.back());
    coarse_ = slips_along(arc, arc.acceleration == 0 ? 1 : pieces / 2, coarse_.back());
    return pressing_part(arc, lost_, [this](double x) { return stress(x, fine_) > 0; });
  }

  /// Stress `x` s after the arc's start, Pa.
  [[nodiscard]] WithError at(double x) const {
    const double value = stress(x, fine_);
    return {std::max(value, 0.0), std::abs(value - stress(x, coarse_)) + 4e-16 * std::abs(value)};
  }

  /// Passes through an arc in place of enter(), at() and leave(); returns the stress at its end.
  [[nodiscard]] double pass(const Arc& arc) {
    if (arc.acceleration != 0) {
      enter(arc);
      const double stress_at_end = at(arc.duration).value;
      leave();
      return stress_at_end;
    }
    const double g = law_.slip().after(fine_.back(), arc.start.rate, arc.duration);
    fine_ = coarse_ = {g};
    const double strain = arc.end.strain;
    const double value = strain > 0 ? law_.stress(strain_of(strain), largest_ - strain, g) : 0;
    largest_ = std::max(largest_, strain);
    return std::max(value, 0.0);
  }

  void leave() {
    largest_ = std::max(largest_, arc_.end.strain);
    fine_ = {fine_.back()};
    coarse_ = {coarse_.back()};
  }

 private:
  static constexpr int pieces = 256;

  /// g at the ends of `count` even pieces of the arc.
  [[nodiscard]] std::vector<double> slips_along(const Arc& arc, int count, double g) const {
    std::vector<double> all{g};
    for (int i = 0; i < count; ++i) {
      const double from = arc.duration * i / count;
      const double to = arc.duration * (i + 1) / count;
      all.push_back(law_.slip().after(all.back(), arc.at(from).rate, arc.at(to).rate, to - from));
    }
    return all;
  }
  [[nodiscard]] double stress(double x, const std::vector<double>& slips) const {
    const Motion motion = arc_.at(x);
    if (motion.strain <= 0) return 0;
    const double count = static_cast<double>(slips.size() - 1);
    const double piece = std::min(std::floor(x / arc_.duration * count), count - 1);
    const double from = arc_.duration * piece / count;
    const double g = law_.slip().after(slips[static_cast<std::size_t>(piece)], arc_.at(from).rate,
                                       motion.rate, std::max(x - from, 0.0));
    return law_.stress(strain_of(motion.strain), largest_ - motion.strain, g);
  }

  FoamStress law_;
  Arc arc_;
  std::vector<double> fine_{0};
  std::vector<double> coarse_{0};
  double largest_ = 0;
  bool lost_ = false;
};

/// A column without memory, whose stress is a curve of the strain. A law that does not recover follows it
/// only while the strain grows beyond the largest one, or is held there.
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
    // Where the strain begins to grow from zero, the jump of the curve has happened.
    const double strain = arc_.at(x).strain;
    const bool grows_from_zero = x == from_ && strain == 0 && arc_.direction() > 0;
    const double stress = grows_from_zero ? curve_.initial_stress : curve_.at(strain);
    return {stress, 4e-16 * stress};
  }

  void leave() { largest_ = std::max(largest_, arc_.end.strain); }

 private:
  /// Time at which the strain passes the largest so far: a root of the parabola, without cancellation.
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

/// A column of viscoelastic foam (theory.md, Eq. 40): exact lasting stress, branches integrated over arcs.
///
///   q(x) = q(0) exp(-x / tau) + integral of g p'(e) de/dt exp(-(x - y) / tau) dy
class MaxwellColumn {
 public:
  explicit MaxwellColumn(const ViscoelasticFoam& law) : law_(law), power_(law.exponents()) {}

  /// A column in tension loses contact and follows the platen without force until it presses again.
  Contact enter(const Arc& arc) {
    arc_ = arc;
    return pressing_part(arc, lost_, [this](double x) { return stress(x).value > 0; });
  }

  /// Stress `x` s after the arc's start, Pa.
  [[nodiscard]] WithError at(double x) const {
    const WithError found = stress(x);
    return {std::max(found.value, 0.0), found.error};
  }

  /// Lasting stress p, Pa.
  [[nodiscard]] double lasting(double strain) const {
    return strain > 0 ? envelope(law_, power_, strain_of(strain), {}, strain) : 0;
  }
  /// Stress q of the first (0) or second (1) branch, `x` s after the arc's start.
  [[nodiscard]] WithError branch(int i, double x) const;

  /// Passes through an arc in place of enter(), at() and leave(); returns the stress at its end.
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
  // What is older than 40 relaxation times has vanished.
  const WithError sum = integral(added, std::max(0.0, x - 40 * time), x, 1e-10, 10);
  return {before.value * kept + sum.value, before.error * kept + sum.error};
}

}  // namespace dashpad::laboratory
