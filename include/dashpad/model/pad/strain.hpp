#pragma once
/// Strain of a pad column, kept together with its distance from full compression.

namespace dashpad {

/// Engineering strain, compression positive, in [0, 1).
/// `complement` is 1 - strain, computed by the caller without cancellation (from the gap L - Y, see
/// docs/theory.md, Eq. 5): near bottoming the difference of nearly equal numbers would lose it.
struct Strain {
  double value = 0;
  double complement = 1;
};

/// For callers far from bottoming.
constexpr Strain strain_of(double value) { return {value, 1 - value}; }

}  // namespace dashpad
