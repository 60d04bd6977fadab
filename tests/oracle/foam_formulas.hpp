#pragma once
/// The laws by curves, written anew for the oracle: nothing here comes from dashpad's own formulas, only the
/// parameters do. No even cells: curves are taken where they are asked for, work is a quadrature.
///
///   foam:           (1 - f) s D(W / W*) + s q,   crushable foam: max(s* - E (e* - e), 0) + s q
///
/// Engineering values, compression positive; stresses in Pa, rates in 1/s.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "dashpad/model/pad/crushable_foam.hpp"
#include "dashpad/model/pad/foam.hpp"

namespace dashpad::oracle {

/// Points and the origin, joined by cubics with slopes of Fritsch and Butland: the harmonic mean, weighted by
/// the widths, of the slopes on both sides; at the ends that of the only side.
class HermiteTable {
 public:
  HermiteTable() = default;
  explicit HermiteTable(const TableCurve& points);
  /// On beyond the last point, straight.
  [[nodiscard]] double value(double x) const;
  [[nodiscard]] double last() const { return x_.back(); }
  [[nodiscard]] double last_slope() const { return slope_.back(); }

 private:
  std::vector<double> x_, y_, slope_;
};

class FoamFormulas {
 public:
  explicit FoamFormulas(const Foam& law);
  explicit FoamFormulas(const CrushableFoam& law);
  FoamFormulas(const FoamFormulas&) = delete;
  FoamFormulas& operator=(const FoamFormulas&) = delete;

  /// s and W; `complement`: 1 - strain.
  [[nodiscard]] double base(double strain, double complement) const;
  [[nodiscard]] double work(double strain, double complement) const;
  /// `ahead`: of the largest strain, over the strain; not cut off at zero.
  [[nodiscard]] double stress(double strain, double complement, double ahead, double u) const;
  /// The same, but below zero where crushed foam has come back all the way: by how much it is left.
  [[nodiscard]] double signed_stress(double strain, double complement, double ahead, double u) const;
  /// u, 1/s.
  [[nodiscard]] double slip_rate(double g) const;

  [[nodiscard]] bool stays_crushed() const { return modulus_.has_value(); }
  [[nodiscard]] double last_strain() const { return last_; }
  /// Largest strains at which the way back changes its form.
  [[nodiscard]] std::vector<double> corners() const;
  [[nodiscard]] double lag() const { return lag_; }           ///< c
  [[nodiscard]] double min_slip_rate() const { return u0_; }  ///< u0, 1/s

 private:
  void set_base(const FoamCurves& curves, double exponent);
  void set_rate_effect(const FoamCurves& curves);
  [[nodiscard]] double multiplier(double strain, double rate) const;  ///< m
  [[nodiscard]] double remaining(double share) const;                 ///< D

  std::function<double(double)> tested_;  ///< base curve up to the last strain
  double last_ = 0, last_stress_ = 0, last_slope_ = 0, exponent_ = 2;
  std::vector<double> work_at_;  ///< at even steps of the root of the strain
  double root_step_ = 0;
  double last_work_ = 0;

  double friction_ = 0, recoil_ = 0;
  double lag_ = 0, u0_ = 0, slowest_ = 0;
  std::function<double(double, double)> multiplier_;

  std::optional<double> modulus_;  ///< of a foam that stays crushed
  double factor_ = 1, shape_ = 1;
  std::vector<double> back_share_, back_value_;  ///< D of an unloading curve over W / W*
};

}  // namespace dashpad::oracle
