#pragma once
/// The shape A(e) = e^m / (1 - e)^n that carries the singularities of a foam's stress at first contact
/// (e = 0) and at full compression (e = 1), and its integral.
///
///   A(e) = e^m (1 - e)^(-n)                                                    (theory.md, Eq. 14)
///   w(e) = integral of A from 0 to e                                           (theory.md, Eq. 19)
///
/// The contact integral is taken over w: stress divided by A is smooth in w at both ends, so few stations
/// suffice. Range: m >= 0, n >= 0, 0 <= e < 1.

#include <array>

#include "dashpad/model/pad/strain.hpp"

namespace dashpad {

struct PowerExponents {
  double m = 1;  ///< exponent at first contact
  double n = 0;  ///< exponent at full compression
  friend bool operator==(const PowerExponents&, const PowerExponents&) = default;
};

class PowerShape {
 public:
  /// The shape and its logarithms at one strain. At strain 0 both logarithms are set to 0.
  struct Value {
    double shape = 0;           ///< A(e)
    double measure = 0;         ///< w(e)
    double log_strain = 0;      ///< ln e
    double log_complement = 0;  ///< ln(1 - e)
  };

  PowerShape() : PowerShape(PowerExponents{}) {}
  explicit PowerShape(PowerExponents exponents);

  [[nodiscard]] Value at(Strain strain) const;
  /// w alone, from a value that is complete but for w; strain > 0.
  [[nodiscard]] double measure(Strain strain, const Value& value) const;
  [[nodiscard]] PowerExponents exponents() const { return exponents_; }

  static constexpr int terms = 16;
  /// Expansions of w, for computing it at many strains at once: with polynomials p in 4x - 1, w = e A p(e) up
  /// to a half, w = offset - (1-e) A p(1-e) - log_weight ln(1-e) above.
  [[nodiscard]] const std::array<double, terms>& near_contact() const { return near_contact_; }
  [[nodiscard]] const std::array<double, terms>& near_bottom() const { return near_bottom_; }
  [[nodiscard]] double offset() const { return offset_; }
  [[nodiscard]] double log_weight() const { return log_weight_; }

 private:
  PowerExponents exponents_;
  double offset_ = 0;      ///< constant of the expansion about full compression
  double log_weight_ = 0;  ///< weight of the logarithmic term, not 0 where n is a whole number
  std::array<double, terms> near_contact_{};
  std::array<double, terms> near_bottom_{};
};

}  // namespace dashpad
