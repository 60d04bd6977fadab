#pragma once
/// What a material test says of a foam as padding: energy, hysteresis, efficiency.
///
/// Over the first loading, with W the energy per volume up to a strain and S the largest stress until there:
///
///   W = integral of stress over strain
///   efficiency = W / S
///   ideality = W / (S strain)
///
/// (Miltz and Gruenbaum 1981; Avalle et al. 2001.) Efficiency and ideality have the unit 1. The foam is used
/// best where the efficiency is highest: that stress is the one to design for.
///
/// W is the work of the test (ColumnTest::work), integrated between the places of output by adaptive
/// quadrature of the exact stress. The number of places does not enter into it.

#include <optional>
#include <vector>

#include "dashpad/laboratory/column_test.hpp"

namespace dashpad::laboratory {

/// One entry a place of output of the first loading at which the strain, > 0, has grown; holds are left out.
struct CushionCurve {
  std::vector<double> strain;
  std::vector<double> stress;      ///< Pa, the largest until there
  std::vector<double> energy;      ///< W, J/m3
  std::vector<double> efficiency;  ///< W / S
  std::vector<double> ideality;    ///< W / (S strain)
};
CushionCurve cushion_curve(const ColumnTest& test);

/// A place of a cushion curve.
struct CushionPoint {
  double strain = 0;
  double stress = 0;  ///< Pa
  double energy = 0;  ///< J/m3
  double efficiency = 0;
  double ideality = 0;
};

struct CushionFigures {
  double peak_stress = 0;        ///< Pa, at a place of output
  double strain_at_peak = 0;     ///< where the peak stress is first reached; not always the largest strain
  double energy_in = 0;          ///< J/m3, while the strain grew, all cycles
  double energy_returned = 0;    ///< J/m3, while it fell
  double hysteresis = 0;         ///< (in - returned) / in; 0 to 1, or below 0 where more came back
  CushionPoint best_efficiency;  ///< the place of output where W/S is highest
  /// Estimated errors of the energies, as a fraction of energy_in.
  double energy_error = 0;
};
CushionFigures cushion_figures(const ColumnTest& test);

/// How much a foam takes without exceeding a stress: the place on the first loading where the stress first
/// reaches `limit` (Pa, > 0; std::invalid_argument otherwise). Absent where the test never reaches it.
///
/// Between two places, ln(stress) is taken as the cubic in ln(strain) through the nearest four; before the
/// first place as a power of the strain. The energy is Hermite's cubic with the stresses as slopes.
/// With 200 places the strain of the Ensolite laws is found to 1e-6 and the energy to a relative 1e-5; before
/// the first place to 2e-5 and 1e-2 (measured, tests/unit/test_cushioning.cpp).
std::optional<CushionPoint> at_stress_limit(const CushionCurve& curve, double limit);

}  // namespace dashpad::laboratory
