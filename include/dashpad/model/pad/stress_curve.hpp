#pragma once
/// A piecewise linear stress-strain curve with a jump at strain zero, as of laws without memory.
///
///   S(e) = S0 [e > 0] + sum over k of dE_k max(e - e_k, 0)                      (theory.md, Eq. 13)
///
/// The form makes the contact force and its work exact (model/contact/curve_contact.hpp).

#include <array>
#include <cassert>
#include <cstddef>

namespace dashpad {

class StressCurve {
 public:
  struct Kink {
    double strain = 0;        ///< strain at which the slope changes, >= 0
    double slope_change = 0;  ///< Pa
  };
  static constexpr int max_kinks = 4;

  double initial_stress = 0;  ///< S0, Pa, >= 0

  void add_kink(double strain, double slope_change) {
    assert(count_ < max_kinks);
    kinks_[static_cast<std::size_t>(count_++)] = {strain, slope_change};
  }
  [[nodiscard]] const Kink* begin() const { return kinks_.data(); }
  [[nodiscard]] const Kink* end() const { return kinks_.data() + count_; }

  [[nodiscard]] double at(double strain) const {
    if (strain <= 0) return 0;
    double stress = initial_stress;
    for (const Kink& kink : *this)
      if (strain > kink.strain) stress += kink.slope_change * (strain - kink.strain);
    return stress;
  }

 private:
  std::array<Kink, max_kinks> kinks_{};
  int count_ = 0;
};

}  // namespace dashpad
