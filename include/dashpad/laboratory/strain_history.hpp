#pragma once
/// What a material test does to a pad column: its strain over time.
///
/// Strain is an engineering value, compression positive, in [0, 1). A history is made of pieces in which the
/// strain is a parabola in time; a straight piece has no acceleration.

#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad::laboratory {

/// strain(t) = strain + rate t + acceleration t^2 / 2, for t from 0 to the piece's duration.
struct StrainPiece {
  double duration = 0;      ///< s, > 0
  double strain = 0;        ///< where it begins
  double rate = 0;          ///< where it begins, 1/s; negative: unloading
  double acceleration = 0;  ///< 1/s2

  [[nodiscard]] double strain_at(double time) const {
    return strain + time * (rate + time * acceleration / 2);
  }
  [[nodiscard]] double rate_at(double time) const { return rate + time * acceleration; }
};

/// Starts at first contact: time 0, stress 0. The pieces follow each other without a jump in strain; the rate
/// may jump.
struct StrainHistory {
  std::vector<StrainPiece> pieces;
};

/// Up and down at constant rate (report, Eq. 29). rate > 0 (1/s), 0 < strain < 1, as in all of these; all
/// throw std::invalid_argument with every rule that is broken.
StrainHistory constant_rate_test(double rate, double strain);

/// A parabola whose mean loading rate is `rate` and whose peak is `strain`, back to zero (report, Eq. 30).
StrainHistory parabolic_test(double rate, double strain);

/// Up at constant rate, then held for `hold` seconds (> 0): stress relaxation.
StrainHistory ramp_and_hold_test(double rate, double strain, double hold);

/// Up to `strain`, down to `low` (0 <= low < strain), and so on, `cycles` times (1 to 1000), at constant
/// rate.
StrainHistory cyclic_test(double rate, double strain, double low, int cycles);

/// Straight between given points, two at least. Times (s) strictly increasing; the first is first contact, at
/// strain 0. History times count from there.
StrainHistory measured_test(const std::vector<double>& times, const std::vector<double>& strains);

/// What makes a history no test: no piece, a duration that is not positive, a strain outside [0, 1), a jump
/// of strain, a start that is not at strain zero, a number that is not finite. Strains may be off by 1e-9,
/// which is rounding. Keys are such as `pieces[3].strain`.
std::vector<Violation> violations(const StrainHistory& history);

}  // namespace dashpad::laboratory
