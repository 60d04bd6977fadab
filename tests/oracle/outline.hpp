#pragma once
/// Noses by their sections, written anew for the oracle from theory.md, Eq. 3: only the numbers are the
/// library's.

#include <functional>
#include <optional>
#include <vector>

#include "dashpad/model/nose/nose.hpp"

namespace dashpad::oracle {

/// A flat tip, then a side up to a depth. SI.
struct Outline {
  double tip = 0;                               ///< area of the flat tip, m2
  double end = 0;                               ///< depth up to which the nose grows wider, m
  std::function<double(double)> widening = {};  ///< growth of the area over the depth, m, at a depth
  std::vector<double> corners = {};             ///< depths at which that jumps
  bool is_steep_at_tip = false;                 ///< it has no bound there

  /// Area of the section at a depth, m2.
  [[nodiscard]] double area(double depth) const;
};

/// `face`: area of a pad that may end before the nose does, m2.
Outline outline_of(const Nose& nose, std::optional<double> face = {});

}  // namespace dashpad::oracle
