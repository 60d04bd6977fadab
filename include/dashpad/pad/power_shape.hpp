#pragma once
/// The shape A(e) = e^m / (1 - e)^n that carries the singularities of a foam's stress at first contact
/// (e = 0) and at full compression (e = 1), and its integral.
///
///   A(e) = e^m (1 - e)^(-n)                                                    (theory.md, Eq. 12)
///   w(e) = integral of A from 0 to e                                           (theory.md, Eq. 22)
///
/// The contact integral is taken over w: stress divided by A is smooth in w at both ends, so few stations
/// suffice. Range: m >= 0, n >= 0, 0 <= e < 1.

#include <array>

#include "dashpad/pad/strain.hpp"

namespace dashpad {

struct PowerExponents {
  double m = 1;  ///< exponent at first contact
  double n = 0;  ///< exponent at full compression
};

class PowerShape {
 public:
  /// All that a column needs of the shape at one strain. At strain 0 both logarithms are set to 0.
  struct Value {
    double shape = 0;           ///< A(e)
    double measure = 0;         ///< w(e)
    double log_strain = 0;      ///< ln e
    double log_complement = 0;  ///< ln(1 - e)
  };

  PowerShape() : PowerShape(PowerExponents{}) {}
  explicit PowerShape(PowerExponents exponents);

  [[nodiscard]] Value at(Strain strain) const;
  [[nodiscard]] PowerExponents exponents() const { return exponents_; }
  /// A'/A = m/e + n/(1 - e), for e > 0.
  [[nodiscard]] double log_slope(Strain strain) const {
    return exponents_.m / strain.value + exponents_.n / strain.complement;
  }

 private:
  static constexpr int terms = 16;
  PowerExponents exponents_;
  double measure_at_half_ = 0;  ///< w(1/2), where the two expansions meet
  double offset_ = 0;           ///< of the expansion about full compression
  double log_weight_ = 0;       ///< of the logarithmic term, present where n is a whole number
  /// Both expansions as polynomials on [0, 1/2]: w = e^(m+1) p(e) and w = offset - (1-e)^(1-n) p(1-e).
  std::array<double, terms> near_contact_{};
  std::array<double, terms> near_bottom_{};
};

}  // namespace dashpad
