#pragma once
/// Values at the nodes of a foam's contact integral (model/contact/work_nodes.hpp), in vectors of nodes.

#include <array>
#include <cmath>
#include <cstddef>

#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {

/// Values at consecutive nodes: the work of the base curve, J/m3; stress and its relaxing, 1/s, over that
/// curve, less the part common to all columns, times a'(s) / (2 pi). Index 0 is the node before them.
struct NodeValues {
  static constexpr std::size_t most = 64;
  static constexpr std::size_t spare = 64;  ///< lanes of the widest known vector
  std::array<double, 1 + most + spare> work{};
  std::array<double, 1 + most + spare> stress{};
  std::array<double, 1 + most + spare> relaxing{};
};

/// A row of `count` nodes from an end of the integral; they are numbered from that end, which is 0.
struct NodeRow {
  double from = 0;  ///< root of the strain there; beyond tested strains ln of its complement
  double step = 0;  ///< distance between nodes
  std::size_t first = 1;
  std::size_t count = 0;  ///< at most NodeValues::most

  /// Root of the strain of node i.
  [[nodiscard]] double root(std::size_t i) const {
    const double even = from + step * static_cast<double>(i);
    return i % 2 == 0 ? even : std::sqrt(even * even + step * step);
  }
  [[nodiscard]] double complement(std::size_t i) const {
    return portable::exp(from - step * static_cast<double>(i));
  }
};

/// Data common to all nodes.
struct FoamNodes {
  FoamStress::Rows stress;
  FoamStress::Ratio common;
  double rate_at_zero = 0;  ///< a' / (2 pi) = rate_at_zero + rate_slope strain, where that is above 0
  double rate_slope = 0;
};

struct FoamNodeMath {
  using Fill = void (*)(const FoamNodes&, const NodeRow&, NodeValues&);
  Fill within = nullptr;  ///< for tested strains
  Fill beyond = nullptr;
};
const FoamNodeMath& foam_node_math();

}  // namespace dashpad
