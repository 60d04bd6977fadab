#pragma once
/// The stress of a column of foam, as a function of its strain, its largest strain and the slip rate.
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

class FoamMemo;
class MonotoneCurve;

class FoamStress {
 public:
  /// The laws must be sound (violations(PadLaw)). `memo` caches tables.
  explicit FoamStress(const Foam& law, FoamMemo* memo = nullptr);
  explicit FoamStress(const CrushableFoam& law);

  /// A strain, with its place in the tables and the base curve there.
  struct Place {
    Strain strain;
    CellPlace cell;
    FoamCurve::Point base;
  };
  /// The place of e = root^2 within the tested strains.
  [[nodiscard]] Place within(double root) const {
    const CellPlace cell = curve_.cells().place(root);
    return {strain_of(root * root), cell, curve_.within(cell)};
  }
  [[nodiscard]] Place beyond(Strain strain) const { return {strain, last_cell, curve_.beyond(strain)}; }
  [[nodiscard]] Place at(Strain strain) const {
    if (strain.value >= curve_.last_strain()) return beyond(strain);
    return within(std::sqrt(std::max(strain.value, 0.0)));
  }

  /// Leading strain less strain of a column whose largest strain is `ahead` of its strain. For crushed foam,
  /// which unloads along a line from it, the largest strain leads; else the own one.
  [[nodiscard]] double lead(double ahead) const { return stays_crushed() ? std::max(ahead, 0.0) : 0; }

  /// The stress of a column over that of the base curve at its leading strain.
  struct Ratio {
    double stress = 0;
    double relaxing = 0;  ///< its rate while the strain is held, 1/s
  };
  /// The ratio of a column. Crushed foam leaves a gap on the way back; `in_crater`: the rate multiplies the
  /// remaining stress, and nothing acts across the gap (theory.md, Eq. 49).
  [[nodiscard]] Ratio ratio(const Place& leading, double ahead, const Overstress::AtRate& at,
                            double slip_rate, bool in_crater = false) const {
    const double relaxation = this->relaxation(slip_rate);
    if (is_of_one_place(ahead)) {
      const Overstress::Value q = overstress_.of(at, leading.strain.value, leading.cell);
      return {(1 - friction_) * remaining(leading, ahead) + q.stress, relaxation * q.rise};
    }
    const double line = 1 - slope_back(leading.strain) * ahead / leading.base.stress;
    const double lasting = std::max(line, 0.0);
    if (slip_rate <= 0 || (in_crater && line <= 0)) return {lasting, 0};
    const Place own = this->at({leading.strain.value - ahead, leading.strain.complement + ahead});
    const Overstress::Value q = overstress_.of(at, own.strain.value, own.cell);
    const double share = in_crater ? line : own.base.stress / leading.base.stress;
    return {lasting + share * q.stress, relaxation * share * q.rise};
  }
  /// Whether the ratio needs the base curve only at the column's strain and its largest strain.
  [[nodiscard]] bool is_of_one_place(double ahead) const { return !stays_crushed() || ahead <= 0; }
  /// The same for batches of places, if is_of_one_place().
  struct Rows {
    FoamCurve::Rows base;
    const double* remaining = nullptr;  ///< D, four numbers for each cell; null: 1
    double ahead = 0;
    double lasting = 1;  ///< 1 - f
    Overstress::AtRate rate;
    Overstress::Rows overstress;
    double relaxation = 0;  ///< 1/s
  };
  [[nodiscard]] Rows rows(double ahead, const Overstress::AtRate& at, double slip_rate) const {
    const bool loses = unloading_ == Unloading::damage && ahead > 0;
    return {curve_.rows(),
            loses ? remaining_.rows() : nullptr,
            ahead,
            1 - friction_,
            at,
            overstress_.rows(at),
            relaxation(slip_rate)};
  }
  /// The stress of one column at an elastic strain g of the slip, Pa (theory.md, Eq. 34).
  [[nodiscard]] double stress(Strain strain, double ahead, double g, bool in_crater = false) const {
    return response(strain, ahead, slip_.slip_rate(g), in_crater).stress;
  }
  /// The stress of one column at a slip rate, Pa, and its rate while the strain is held, Pa/s.
  [[nodiscard]] Ratio response(Strain strain, double ahead, double slip_rate, bool in_crater = false) const {
    const double beyond = lead(ahead);
    const Place leading = at({strain.value + beyond, strain.complement - beyond});
    const Ratio of = ratio(leading, ahead, overstress_.at(slip_rate), slip_rate, in_crater);
    return {leading.base.stress * of.stress, leading.base.stress * of.relaxing};
  }
  /// The strain of the axis at which a nose meets the foam again that it had strained to `largest` there and
  /// to at least `least` beside it: a column springs back by s(e*) / max(E, s'(e*)) (theory.md, Eq. 48).
  [[nodiscard]] double strain_of_crater(double largest, double least) const;
  /// Whether the ratio is the same at all strains.
  [[nodiscard]] bool is_even(double ahead, const Overstress::AtRate& at) const {
    return (ahead <= 0 || unloading_ == Unloading::none) && at.even;
  }
  /// Whether the ratio grows with the strain, so that columns lose their stress from the edge inwards.
  [[nodiscard]] bool lets_go_from_one_side(const Overstress::AtRate& at) const {
    return at.even && !has_tested_way_back_;
  }

  /// Whether the ratio follows the points of tested curves.
  [[nodiscard]] bool has_points() const { return has_tested_way_back_ || overstress_.has_points(); }

  [[nodiscard]] const FoamCurve& curve() const { return curve_; }
  [[nodiscard]] const Overstress& overstress() const { return overstress_; }
  [[nodiscard]] const SlipScale& slip() const { return slip_; }
  /// Slope of unloading of crushed foam, Pa: the modulus, or the slope of the crush curve if steeper.
  [[nodiscard]] double slope_back(Strain largest) const {
    return std::max(modulus_, curve_.slope_beyond(largest));
  }
  /// Integral of slope_back() times the line `at_zero` + `rise` e over largest strains between two places.
  [[nodiscard]] double moment_of_slope_back(const Place& from, const Place& to, double at_zero,
                                            double rise) const;
  /// The largest strain e* of the most stressed column of crushed foam after all strains have come back by
  /// `ahead`: s(e*) - max(E, s'(e*)) ahead has its maximum there.
  [[nodiscard]] double longest_pressed(double ahead) const {
    return curve_.strain_where_steep(modulus_, ahead);
  }
  [[nodiscard]] bool stays_crushed() const { return unloading_ == Unloading::elastic; }

 private:
  enum class Unloading { none, damage, elastic };
  inline static const Cells whole{1};  ///< cells of x, the share of the work
  static constexpr CellPlace last_cell{Cells::count - 1, 1};

  FoamStress(const Foam& law, FoamCurve curve, FoamMemo* memo);

  /// Rate of ln |u| while the strain is held, with the sign of the stress's change, 1/s.
  [[nodiscard]] double relaxation(double slip_rate) const {
    return (slip_rate < 0 ? 1 : -1) * (std::abs(slip_rate) + slip_.rate) / slip_.strain;
  }
  /// D(W(e) / W(e*)).
  [[nodiscard]] double remaining(const Place& place, double ahead) const {
    if (unloading_ == Unloading::none || ahead <= 0) return 1;
    const double most = curve_.at({place.strain.value + ahead, place.strain.complement - ahead}).work;
    return remaining_.at(whole.place(std::sqrt(place.base.work / most)));
  }
  /// D by a curve of unloading, for x in [0, 1].
  [[nodiscard]] double share_of(const MonotoneCurve& back, double x) const;

  Unloading unloading_ = Unloading::none;
  bool has_tested_way_back_ = false;  ///< whether D follows a curve; it may then fall with the strain
  double friction_ = 0;
  double modulus_ = 0;  ///< E
  FoamCurve curve_;
  SlipScale slip_;
  Overstress overstress_;
  CellTable remaining_;  ///< D as a function of the root of x
};

}  // namespace dashpad
