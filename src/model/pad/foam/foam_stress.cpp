#include "model/pad/foam/foam_stress.hpp"

#include <algorithm>
#include <utility>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/foam_memo.hpp"
#include "model/pad/foam/monotone_curve.hpp"

namespace dashpad {
namespace {

SlipScale scale_of(double lag_strain, const FoamCurves& curves) {
  return {lag_strain / 20, curves.slowest_rate / 1000};
}

}  // namespace

FoamStress::FoamStress(const Foam& law, FoamMemo* memo)
    : FoamStress(law,
                 memo != nullptr ? memo->curve(law.curves.base, law.continuation_exponent)
                                 : FoamCurve(law.curves.base, law.continuation_exponent),
                 memo) {}

FoamStress::FoamStress(const Foam& law, FoamCurve curve, FoamMemo* memo)
    : friction_(law.friction),
      curve_(std::move(curve)),
      slip_(scale_of(law.lag_strain, law.curves)),
      overstress_(law.curves, curve_, law.friction, law.recoil, slip_.rate) {
  if (law.unloading_curve) {
    unloading_ = Unloading::damage;
    has_tested_way_back_ = true;
    const MonotoneCurve back(*law.unloading_curve);
    remaining_.fill(Cells(1), [&](double root) { return share_of(back, std::min(root * root, 1.0)); });
  } else if (law.unloading_factor < 1) {
    unloading_ = Unloading::damage;
    const auto make = [&law] {
      CellTable table;
      table.fill(Cells(1), [&law](double root) {
        return 1 - (1 - law.unloading_factor) * (1 - portable::pow(root * root, law.unloading_shape));
      });
      return table;
    };
    remaining_ = memo != nullptr ? memo->way_back(law.unloading_factor, law.unloading_shape, make) : make();
  }
}

double FoamStress::share_of(const MonotoneCurve& back, double x) const {
  const double last = curve_.last_strain();
  const double work = x * curve_.at(strain_of(last)).work;
  // The strain at which the base curve has done this work.
  double low = 0;
  double high = last;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (curve_.at(strain_of(middle)).work < work ? low : high) = middle;
  }
  if (x >= 1) return 1;
  const double loading = curve_.at(strain_of(high)).stress;
  return loading > 0 ? std::clamp((back.stress(high) / loading + friction_) / (1 - friction_), 0.0, 1.0) : 0;
}

double FoamStress::strain_of_crater(double largest, double least) const {
  if (!stays_crushed()) return 0;
  const auto sprung_back = [this](double strain) {
    const Strain at_strain = dashpad::strain_of(strain);
    return curve_.at(at_strain).stress / slope_back(at_strain);
  };
  // The recovery grows with the strain until the curve is steeper than the unloading, and falls beyond.
  const double steep = curve_.strain_where_steep(modulus_, infinite);
  const double most = std::max(sprung_back(largest), sprung_back(std::clamp(steep, least, largest)));
  return std::max(largest - most, 0.0);
}

double FoamStress::moment_of_slope_back(const Place& from, const Place& to, double at_zero,
                                        double rise) const {
  const auto constant = [&](double begin, double end) {
    return modulus_ * (end - begin) * (at_zero + rise * (begin + end) / 2);
  };
  // The crush curve's own slope, integrated by parts.
  const auto curved = [&](const Place& begin, const Place& end) {
    const auto at = [&](const Place& place) {
      return place.base.stress * (at_zero + rise * place.strain.value);
    };
    return at(end) - at(begin) - rise * (end.base.work - begin.base.work);
  };
  const double steep = curve_.strain_where_steep(modulus_, infinite);
  if (to.strain.value <= steep) return constant(from.strain.value, to.strain.value);
  if (from.strain.value >= steep) return curved(from, to);
  return constant(from.strain.value, steep) + curved(at(dashpad::strain_of(steep)), to);
}

FoamStress::FoamStress(const CrushableFoam& law)
    : unloading_(Unloading::elastic),
      modulus_(law.unloading_modulus),
      curve_(law.curves.base, law.continuation_exponent),
      slip_(scale_of(law.lag_strain, law.curves)),
      overstress_(law.curves, curve_, 0, 0, slip_.rate) {}

}  // namespace dashpad
