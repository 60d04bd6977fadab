#pragma once
/// The stress of a single pad column in a material test, exact up to quadrature.
///
/// Along a history the law is a linear equation for the stress (theory.md, Eq. 8; report, Eq. 28):
///
///   d(stress)/dt = dG/dt | (rate and largest strain held) + h (G - stress)
///
/// On a straight piece it has a closed-form solution (theory.md, Eq. 9; law 5 needs the integral of h by
/// quadrature). On a parabolic one the memory integral is computed by adaptive and double-exponential
/// quadrature, which copes with the infinite slopes at strain zero and rate zero. There are no time steps:
/// the places of output change no stress.
///
/// Where the rate jumps, the stress of laws 2, 4 and 5 is continuous, although their envelope jumps. Where
/// the stress would become tensile, contact is lost: the stress is zero until the strain grows again, and the
/// column is then loaded from stress zero. Law 3 does not recover. See docs/laboratory.md.

#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {
class FoamMemo;
}

namespace dashpad::laboratory {

// The strain of a pad column over time: an engineering value, compression positive, in [0, 1). A history
// consists of pieces in which the strain is a parabola in time; a straight piece has no acceleration.

/// A piece of a history: strain(t) = strain + rate t + acceleration t^2 / 2, for t from 0 to its duration.
struct StrainPiece {
  double duration = 0;      ///< s, > 0
  double strain = 0;        ///< strain at its start
  double rate = 0;          ///< strain rate at its start, 1/s; negative on unloading
  double acceleration = 0;  ///< 1/s2

  [[nodiscard]] double strain_at(double time) const {
    return strain + time * (rate + time * acceleration / 2);
  }
  [[nodiscard]] double rate_at(double time) const { return rate + time * acceleration; }
};

/// A history that starts at first contact, at time 0 and stress 0. The rate may jump, the strain must not.
struct StrainHistory {
  std::vector<StrainPiece> pieces;
};

/// Loading to `strain` and unloading at constant rate (report, Eq. 29). In this and the next functions rate >
/// 0, 1/s, and 0 < strain < 1; all throw std::invalid_argument that names every broken rule.
StrainHistory constant_rate_test(double rate, double strain);

/// A parabola from zero to `strain` and back, with the mean loading rate `rate` (report, Eq. 30).
StrainHistory parabolic_test(double rate, double strain);

/// Stress relaxation: loading at constant rate, then a hold of `hold` s, > 0.
StrainHistory ramp_and_hold_test(double rate, double strain, double hold);

/// `cycles` (1 to 1000) cycles between `low` and `strain` at constant rate, 0 <= low < strain.
StrainHistory cyclic_test(double rate, double strain, double low, int cycles);

/// A history that is linear between given points, at least two. Times in s, strictly increasing; the first is
/// first contact, at strain 0, from which the times of the history count.
StrainHistory measured_test(const std::vector<double>& times, const std::vector<double>& strains);

/// The rules that a history breaks: it needs a piece, positive durations, strains in [0, 1) that start at 0
/// and do not jump, and finite numbers. Strains may be off by 1e-9. Keys are such as `pieces[3].strain`.
std::vector<Violation> violations(const StrainHistory& history);

/// An event in a test. The course of the strain and the contact have events of their own: reloading after
/// lost contact is `reloaded` and `contact_taken_up`, at the same time except for law 3.
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

/// A column test, with an entry for each place of output, also at the ends of pieces and at events; stress
/// and strain are positive in compression. Where the stress jumps (law 3) there are two entries.
struct ColumnTest {
  std::vector<double> time;  ///< s since first contact
  std::vector<double> strain;
  std::vector<double> rate;    ///< 1/s; at a jump that of the piece that ends
  std::vector<double> stress;  ///< Pa, >= 0
  std::vector<double> work;    ///< work done on the column so far, the integral of stress over strain, J/m3
  std::vector<ColumnEvent> events;
  double largest_strain = 0;
  double stress_error = 0;  ///< largest estimated error of a stress, as a fraction of the peak stress
  double work_error = 0;    ///< estimated error of the whole work, J/m3
  [[nodiscard]] std::size_t size() const { return time.size(); }
};

/// Leads a column through a history, with `places` (2 to 100,000) places of output in each piece, even in
/// time, at most 10,000,000 in all. Throws std::invalid_argument for broken rules of law, history or places.
ColumnTest drive(const PadLaw& law, const StrainHistory& history, int places = 200);

/// Stress of a column at the end of each piece of a history, Pa: that of drive() without other places of
/// output and error estimates, for fits. Law and history are not checked: they must have no violations(), but
/// a base curve may fall, as during the search of a fit. `memo` caches tables of this thread
/// (src/model/pad/foam/foam_memo.hpp).
std::vector<double> stress_at_ends(const PadLaw& law, const StrainHistory& history, FoamMemo* memo = nullptr);

/// A creep test: loading at a constant rate until a stress is reached, which is then held.
struct CreepTest {
  double stress = 0;        ///< Pa, > 0
  double loading_rate = 0;  ///< 1/s, > 0
  double hold = 0;          ///< time after the loading, s, > 0
};

/// The strain under that stress. While the stress is constant, (dG/de) rate + h (G - stress) = 0 determines
/// the rate, which is integrated to a relative 1e-12 (law 2 has a closed form; laws 1 and 3 do not creep, and
/// law 3 stays at strain 0 below its crush stress). Nothing if the law does not reach the stress below the
/// strain 0.999, or creeps beyond it. There are `places` places of output during the loading, even in time,
/// and as many during the hold, in geometric sequence. `stress_error` is the estimated error of the strain
/// times the slope of the lasting stress. Throws std::invalid_argument for broken rules.
std::optional<ColumnTest> creep(const PadLaw& law, const CreepTest& test, int places = 200);

}  // namespace dashpad::laboratory
