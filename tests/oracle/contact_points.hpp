#pragma once
/// Places of a contact at which a stress that rises towards the axis like a power of the depth, or as if the
/// pad closed there, is summed up.

#include <vector>

#include "oracle/outline.hpp"

namespace dashpad::oracle {

struct ContactPoint {
  double depth = 0;  ///< s, m
  double above = 0;  ///< y - s, without cancellation, m
  double area = 0;   ///< that it stands for, m2
};

/// By Gauss in panels that grow with the distance from the axis and from the edge. `gap`: what is
/// left of the pad, m.
std::vector<ContactPoint> contact_points(const Outline& nose, double y, double gap, int fineness);

}  // namespace dashpad::oracle
