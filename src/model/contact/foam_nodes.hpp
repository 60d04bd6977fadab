#pragma once
/// Values at the nodes of a foam's contact integral (model/contact/work_nodes.hpp) by vectors of nodes, for
/// the instruction set of the processor that the program runs on.

#include <array>
#include <cmath>
#include <cstddef>

#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {

/// What is asked for at nodes one after the other: the work of the base curve, J/m3, and of the stress over
/// that curve's and of its relaxing in 1/s what exceeds the part that all columns have in common, each times
/// the nose's rate of the section a'(s) / (2 pi). The first is that of the node before them.
struct NodeValues {
  static constexpr std::size_t most = 64;
  static constexpr std::size_t spare = 64;  ///< lanes of the widest vector that is known
  std::array<double, 1 + most + spare> work{};
  std::array<double, 1 + most + spare> stress{};
  std::array<double, 1 + most + spare> relaxing{};
};

/// Nodes from an end of the integral on; `first` and `count` of them, 1: the first one off that end.
struct NodeRow {
  double from = 0;  ///< the root of the strain; beyond the tested strains the logarithm of the complement
  double step = 0;  ///< from node to node
  std::size_t first = 1;
  std::size_t count = 0;  ///< at most NodeValues::most

  /// Of a number.
  [[nodiscard]] double root(std::size_t i) const {
    const double even = from + step * static_cast<double>(i);
    return i % 2 == 0 ? even : std::sqrt(even * even + step * step);
  }
  [[nodiscard]] double complement(std::size_t i) const {
    return std::exp(from - step * static_cast<double>(i));
  }
};

/// What is the same for all nodes.
struct FoamNodes {
  FoamStress::Rows stress;
  FoamStress::Ratio common;
  double rate_at_zero = 0;  ///< a' / (2 pi) = rate_at_zero + rate_slope strain, where that is above 0
  double rate_slope = 0;
};

struct FoamNodeMath {
  using Fill = void (*)(const FoamNodes&, const NodeRow&, NodeValues&);
  Fill within = nullptr;  ///< the tested strains
  Fill beyond = nullptr;
};
const FoamNodeMath& foam_node_math();

}  // namespace dashpad
