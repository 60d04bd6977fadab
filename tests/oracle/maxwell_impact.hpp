#pragma once
/// A viscoelastic foam (theory.md, Eq. 40) in the CVODE oracle.
///
/// A branch is written by what it remembers, not by its stress: q = g (p - r) with dr/dt = (p - r) / tau, so
/// no rate of strain is needed, and the penetration is the root of F = Fs(X - Y), taken anew at each call.
///
/// Loading: no column is in tension, so the force needs only the integrals R of the remembered stresses over
/// the
///   contact:  F = (1 + g1 + g2) P(Y) - g1 R1 - g2 R2,  dR/dt = (P(Y) - R) / tau,  where P is the integral of
///   p.
/// Unloading: columns at fixed depths s = Ymax (1 - x^2), x at Chebyshev points, unknown r. Each begins with
/// the
///   integral of its history of loading. Its stress may be negative; only the positive part counts, and its
///   ends are found by bisection.
/// A flat disc has one column, and the form of loading holds until the release.

#include <array>

#include "dashpad/model/nose/nose.hpp"
#include "dashpad/model/pad/viscoelastic_foam.hpp"
#include "oracle/impact_run.hpp"

namespace dashpad::oracle {

/// Law of a column, written anew from Eq. 40: only the parameters are the library's.
class MaxwellFormulas {
 public:
  explicit MaxwellFormulas(const ViscoelasticFoam& law);

  /// p, Pa, and its slope; also at negative strains, where it goes on smoothly.
  [[nodiscard]] double lasting(double strain) const;
  [[nodiscard]] double lasting_slope(double strain) const;

  static constexpr std::size_t branches = 2;
  std::array<double, branches> share{};  ///< g
  std::array<double, branches> time{};   ///< tau, s
  double sudden = 1;                     ///< 1 + g1 + g2

 private:
  struct Term {
    double factor = 0;  ///< 2 mu / alpha, Pa
    double exponent = 0;
  };
  std::array<Term, 2> terms_{};
};

/// Whole impact of a sphere or a flat disc. Penetrations beyond the largest one of loading end it as
/// reloading. The drift is that of the force where the columns take over from the integrals.
void solve_maxwell(ImpactRun& run, const MaxwellFormulas& law, const Nose& nose);

}  // namespace dashpad::oracle
