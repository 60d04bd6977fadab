#pragma once
/// Cushion curves in the manner of ASTM D1596: peak deceleration over static stress, for drop heights and
/// thicknesses.
///
/// The standard drops a flat platen, wider than the cushion. The loaded area of a sphere grows during the
/// impact; that of a flat disc does not, but the pad is wider than the disc. Static stress here is the weight
/// over the area of the contact, projected along the direction of impact, at the largest penetration d,
///
///   static stress = M g / a(d)                                                         (theory.md, Eq. 3);
///
/// drop height is v^2 / 2 g. Curves of a sphere lie elsewhere than those of a platen and must not be mixed
/// with them.

#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/study/answers.hpp"

namespace dashpad::study {

struct CushionCurve {
  double thickness = 0;                   ///< m
  std::vector<double> static_stress;      ///< Pa, in the order of the masses
  std::vector<double> peak_deceleration;  ///< m/s2; NaN where the impact has none
};

/// Where on the curve the peak is least. None without a finite one.
std::optional<std::size_t> least_peak(const CushionCurve& curve);

struct CushionCurves {
  struct Drop {
    double height = 0;  ///< m
    double speed = 0;   ///< m/s
    std::vector<CushionCurve> curves;
  };
  std::vector<Drop> drops;     ///< the highest last
  bool whole_cushion = false;  ///< the nose is flat and covers all of the pad, as in ASTM D1596
};

/// Absent unless the study is a grid of impactor.mass (or impactor.weight) and at most speed and thickness
/// besides, and keeps peak_acceleration and peak_penetration.
std::optional<CushionCurves> cushion_curves(const Study& study, const Records& records);

}  // namespace dashpad::study
