#pragma once
/// The stress of a foam's column, by its strain, the largest strain it has seen, and the slip rate.
///
///   foam:           (1 - f) s(e) D(W(e) / W(e*)) + s(e) q(e, u)                (theory.md, Eq. 32)
///   crushable foam: max(s(e*) - E (e* - e), 0) + s(e) q(e, u)                  (theory.md, Eq. 38)
///
/// Stress in Pa, compression positive.

#include <algorithm>
#include <cmath>

#include "dashpad/model/pad/crushable_foam.hpp"
#include "dashpad/model/pad/foam.hpp"
#include "dashpad/model/pad/law.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "model/pad/foam/overstress.hpp"
#include "model/pad/foam/slip.hpp"

namespace dashpad {

class MonotoneCurve;

class FoamStress {
 public:
  /// The laws must be sound (violations(PadLaw)).
  explicit FoamStress(const Foam& law);
  explicit FoamStress(const CrushableFoam& law);

  /// A column, as far as its strain goes.
  struct Place {
    Strain strain;
    CellPlace cell;
    FoamCurve::Point base;
  };
  /// Where e = root^2 lies within the tested strains.
  [[nodiscard]] Place within(double root) const {
    const CellPlace cell = curve_.cells().place(root);
    return {strain_of(root * root), cell, curve_.within(cell)};
  }
  [[nodiscard]] Place beyond(Strain strain) const { return {strain, last_cell, curve_.beyond(strain)}; }
  [[nodiscard]] Place at(Strain strain) const {
    if (strain.value >= curve_.last_strain()) return beyond(strain);
    return within(std::sqrt(std::max(strain.value, 0.0)));
  }

  /// The part that does not know the rate; `largest` >= the strain. A crushed foam that has come back leaves
  /// a gap: `least` 0, or the line of its unloading goes on.
  [[nodiscard]] double lasting(const Place& place, Strain largest, double least = 0) const {
    const double most = (1 - friction_) * place.base.stress;
    if (unloading_ == Unloading::none || largest.value <= place.strain.value) return most;
    const FoamCurve::Point top = curve_.at(largest);
    if (unloading_ == Unloading::elastic) {
      // Where the crush curve is steeper than the unloading, the foam comes back as steeply as it went.
      const double slope = std::max(modulus_, curve_.slope_beyond(largest));
      return std::max(top.stress - slope * (largest.value - place.strain.value), least);
    }
    return most * remaining_.at(Cells(1).place(std::sqrt(place.base.work / top.work)));
  }
  struct Rate {
    double stress = 0;    ///< Pa
    double relaxing = 0;  ///< its change with time while the strain is held, Pa/s
  };
  /// The part of the rate.
  [[nodiscard]] Rate of_rate(const Place& place, const Overstress::AtRate& at, double slip_rate) const {
    const Overstress::Value q = overstress_.of(at, place.strain.value, place.cell);
    const double u = std::abs(slip_rate);
    const double side = slip_rate < 0 ? 1 : -1;
    return {place.base.stress * q.stress,
            side * place.base.stress * q.rise * (u + slip_.rate) / slip_.strain};
  }

  [[nodiscard]] const FoamCurve& curve() const { return curve_; }
  [[nodiscard]] const Overstress& overstress() const { return overstress_; }
  [[nodiscard]] const SlipScale& slip() const { return slip_; }
  /// The largest strain of the column of a crushed foam whose stress is largest where all strains have come
  /// back by `ahead`: s(e*) - max(E, s'(e*)) ahead has its maximum there.
  [[nodiscard]] double longest_pressed(double ahead) const {
    return curve_.strain_where_steep(modulus_, ahead);
  }
  [[nodiscard]] bool stays_crushed() const { return unloading_ == Unloading::elastic; }

 private:
  enum class Unloading { none, damage, elastic };
  static constexpr CellPlace last_cell{Cells::count - 1, 1};

  /// D where the foam comes back along a curve, x in [0, 1].
  [[nodiscard]] double share_of(const MonotoneCurve& back, double x) const;

  Unloading unloading_ = Unloading::none;
  double friction_ = 0;
  double modulus_ = 0;  ///< E
  FoamCurve curve_;
  SlipScale slip_;
  Overstress overstress_;
  CellTable remaining_;  ///< D over the root of x
};

}  // namespace dashpad
