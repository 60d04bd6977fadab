#pragma once
/// A column of foam on its way through a history (theory.md, Eqs. 32 to 38).
///
/// The slip follows an arc of constant rate exactly; a parabola is cut into pieces, and the error estimated
/// by pieces of twice the length. The stress is a function of strain and slip, so the column presses wherever
/// that is more than nothing, also when it is loaded again.

#include <algorithm>
#include <cmath>
#include <vector>

#include "laboratory/column.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad::laboratory {

class FoamColumn {
 public:
  template <SharesSlip Law>
  explicit FoamColumn(const Law& law) : law_(law) {}
  FoamColumn(const Foam& law, FoamMemo& memo) : law_(law, memo) {}

  Contact enter(const Arc& arc) {
    arc_ = arc;
    fine_ = slips_along(arc, arc.acceleration == 0 ? 1 : pieces, fine_.back());
    coarse_ = slips_along(arc, arc.acceleration == 0 ? 1 : pieces / 2, coarse_.back());
    return pressing_part(arc, lost_, [this](double x) { return stress(x, fine_) > 0; });
  }

  /// `x` s after the arc's start.
  [[nodiscard]] WithError at(double x) const {
    const double value = stress(x, fine_);
    return {std::max(value, 0.0), std::abs(value - stress(x, coarse_)) + 4e-16 * std::abs(value)};
  }

  /// Goes through an arc at once; the stress at its end. In place of enter(), at() and leave().
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

  /// g at the ends of even pieces of the arc.
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

}  // namespace dashpad::laboratory
