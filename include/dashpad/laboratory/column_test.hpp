#pragma once
/// The stress of a single pad column in a material test, exact up to quadrature.
///
/// Along a history the law is a linear equation for the stress (theory.md, Eq. 8; report, Eq. 28):
///
///   d(stress)/dt = dG/dt | (rate and largest strain held) + h (G - stress)
///
/// On a straight piece it integrates in closed form (theory.md, Eq. 9; law 5 needs the integral of h by
/// quadrature); on a parabolic one the memory integral is taken by adaptive and double-exponential
/// quadrature, which takes the infinite slopes at strain zero and rate zero. There are no time steps: the
/// places of output change no stress.
///
/// Where the rate jumps, the stress of laws 2, 4 and 5 is continuous; their envelope jumps. Where the stress
/// would turn tensile, contact is lost: the stress is zero until the strain grows again; then the column is
/// loaded from stress zero. Law 3 does not recover. docs/laboratory.md tells all.

#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {
class FoamMemo;
}

namespace dashpad::laboratory {

// What a material test does to a pad column: its strain over time.
//
// Strain is an engineering value, compression positive, in [0, 1). A history is made of pieces in which the
// strain is a parabola in time; a straight piece has no acceleration.

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

// The column.

/// What happened on the way. The strain's course and the contact are told apart: a reloading after contact
/// was lost is `reloaded` and `contact_taken_up`, at the same time but for law 3.
struct ColumnEvent {
  enum class Kind {
    turned,           ///< loading, or a hold after it, became unloading
    reloaded,         ///< unloading, or a hold after it, became loading
    contact_lost,     ///< the stress fell to zero on unloading
    contact_taken_up  ///< reloading from stress zero
  };
  Kind kind = Kind::turned;
  double time = 0;  ///< s
  double strain = 0;
  double stress_before = 0;  ///< Pa
  double stress_after = 0;   ///< Pa; differs from the one before for law 3 only
  std::size_t place = 0;     ///< index of the place of output at which it happened
};

/// One entry a place of output; stress and strain positive in compression. The ends of all pieces, and the
/// events, are places of output. Where the stress jumps (law 3), the place is there twice, before and after.
struct ColumnTest {
  std::vector<double> time;  ///< s since first contact
  std::vector<double> strain;
  std::vector<double> rate;    ///< 1/s; where it jumps, that of the piece that ends
  std::vector<double> stress;  ///< Pa, >= 0
  std::vector<double> work;    ///< J/m3 done on the column until then: integral of stress over strain
  std::vector<ColumnEvent> events;
  double largest_strain = 0;
  double stress_error = 0;  ///< largest estimated error of a stress, as a fraction of the peak stress
  double work_error = 0;    ///< estimated error of the work, of all places together, J/m3
  [[nodiscard]] std::size_t size() const { return time.size(); }
};

/// Drives a column through a history, with `places` (2 to 100,000) places of output in each piece, even in
/// time; 10,000,000 in all at most. Throws std::invalid_argument for violations() of the law or of the
/// history, and for places beyond these numbers.
ColumnTest drive(const PadLaw& law, const StrainHistory& history, int places = 200);

/// Stress of a column, Pa, at the end of each piece of a history: that of drive(), without places of output
/// in between and without estimated errors, for fits, which ask often. Neither law nor history is checked:
/// they must have no violations(), but a base curve may fall, as it does while a fit searches.
/// `memo` of this thread has tables that earlier calls made (src/model/pad/foam/foam_memo.hpp).
std::vector<double> stress_at_ends(const PadLaw& law, const StrainHistory& history, FoamMemo* memo = nullptr);

/// Loaded at a constant rate until a stress is reached, then held at that stress: creep.
struct CreepTest {
  double stress = 0;        ///< Pa, > 0
  double loading_rate = 0;  ///< 1/s, > 0
  double hold = 0;          ///< s after the loading, > 0
};

/// The strain under that stress: while the stress stands still, (dG/de) rate + h (G - stress) = 0 gives the
/// rate, which is integrated to a relative 1e-12 (law 2: closed form; laws 1 and 3: the strain stands still
/// at once; law 3 below its crush stress at strain 0). Absent where the law cannot reach the stress below
/// strain 0.999, or creeps beyond it. `places` during loading, even in time, and as many during the hold, at
/// times after the loading in geometric sequence. `stress_error` is what the estimated error of the strain is
/// worth on the lasting stress. Throws std::invalid_argument for violations() of the law, and for figures
/// that are not as above.
std::optional<ColumnTest> creep(const PadLaw& law, const CreepTest& test, int places = 200);

}  // namespace dashpad::laboratory
