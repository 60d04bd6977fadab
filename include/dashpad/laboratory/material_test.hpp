#pragma once
/// A pad material in the laboratory: a column driven through a test at several strain rates, and what that
/// says of the material. docs/laboratory.md explains tests and figures.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "dashpad/model/pad/material.hpp"

namespace dashpad::laboratory {

// What a material test says of a foam as padding: energy, hysteresis, efficiency.
//
// Over the first loading, with W the energy per volume up to a strain and S the largest stress until there:
//
//   W = integral of stress over strain
//   efficiency = W / S
//   ideality = W / (S strain)
//
// (Miltz and Gruenbaum 1981; Avalle et al. 2001.) The foam is used best where the efficiency is highest: that
// stress is the one to design for. W is the work of the test, whatever the number of places.

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
/// first place as a power of the strain. With 200 places the strain of the Ensolite laws is found to 1e-6 and
/// the energy to a relative 1e-5.
std::optional<CushionPoint> at_stress_limit(const CushionCurve& curve, double limit);

// The test and its report.

enum class TestKind {
  constant_rate,  ///< up and down at constant rate (report, Eq. 29)
  parabolic,      ///< up and down on a parabola (report, Eq. 30)
  relaxation,     ///< up at constant rate, then held at that strain
  creep,          ///< up at constant rate, then held at a stress
  cyclic,         ///< up and down between two strains
  history,        ///< a strain history that was measured
};
inline constexpr TestKind all_test_kinds[] = {TestKind::constant_rate, TestKind::parabolic,
                                              TestKind::relaxation,    TestKind::creep,
                                              TestKind::cyclic,        TestKind::history};
/// "constant-rate" and so on, as on the command line.
const char* to_string(TestKind kind);

/// Strains are engineering values, compression positive, in [0, 1).
struct MaterialTest {
  TestKind kind = TestKind::constant_rate;
  std::vector<double> rates = {1, 100};           ///< 1/s, > 0: of loading; unused by a measured history
  double strain = 0.95;                           ///< the largest; unused by creep and a measured history
  double hold = 1;                                ///< s, > 0: relaxation and creep
  double stress = 0;                              ///< Pa, > 0: creep
  double low = 0;                                 ///< cyclic: where unloading ends, < strain
  int cycles = 3;                                 ///< cyclic: 1 to 1000
  std::string history_name = {};                  ///< where the measured history comes from
  std::vector<std::string> history_remarks = {};  ///< on how it was read
  std::vector<double> times = {};                 ///< s: measured history
  std::vector<double> strains = {};               ///< measured history
  std::vector<double> stress_limits = {};         ///< Pa, > 0: cushioning is asked for at these
  /// The update of 1984 too, with that many steps (1 to 10,000) to the first loading. Not for creep.
  std::optional<int> steps_of_1984 = {};
};

/// Two stresses on either side of the end of the first loading, Pa.
struct StressAtTurn {
  double last_loading = 0;
  double next = 0;  ///< one step of the update of 1984 later
  [[nodiscard]] double jump() const { return next - last_loading; }
};

/// The update of 1984 (report, Eq. 16) on the same history, in the arithmetic of its machine.
struct UpdateOf1984 {
  double step = 0;           ///< s: the duration of the first loading over the number of steps
  std::vector<double> time;  ///< s
  std::vector<double> strain;
  std::vector<double> stress;  ///< Pa
  std::vector<double> exact;   ///< Pa: the exact stress at the same times
  /// Where the test goes on after its first loading. A jump above zero is what the report calls the
  /// stress-discontinuity artifact.
  std::optional<StressAtTurn> update_at_turn, exact_at_turn;
};

/// Stresses of 1984 outside these shares of the exact peak stress are flagged as OUT OF BOUNDS and not drawn.
inline constexpr double lowest_drawn = -0.1, highest_drawn = 1.5;

/// Stress relaxation, Pa.
struct RelaxedStress {
  double at_end_of_ramp = 0;
  double after_tenth = 0;  ///< of the hold
  double after_hold = 0;
};

struct CreptStrain {
  double at_end_of_loading = 0;
  double after_hold = 0;
};

/// The test at one rate.
struct MaterialTestRun {
  std::optional<double> rate;  ///< 1/s; absent for a measured history
  ColumnTest column;
  CushionCurve cushion;
  CushionFigures figures;
  bool unloads = false;                                ///< without, no energy can be returned
  std::vector<std::optional<CushionPoint>> at_limits;  ///< one each stress limit; absent where not reached
  std::optional<RelaxedStress> relaxed;
  std::optional<CreptStrain> crept;
  std::optional<UpdateOf1984> update_of_1984;
  std::vector<Flag> flags;  ///< EXTRAPOLATED, ASSUMPTION, ENERGY GAIN, OUT OF BOUNDS
};

struct MaterialTestReport {
  Material material;
  MaterialTest test;
  std::vector<MaterialTestRun> runs = {};  ///< one each rate
};

/// Stresses of a column by an explicit update, Pa, at strains `step` s apart, the first of them 0:
/// spit1984::stresses_of_update.
using StressUpdate = std::vector<double> (*)(const Material& material, const std::vector<double>& strains,
                                             double step);

/// Runs the test. Throws std::invalid_argument for violations() of the law or of a history, for a creep
/// stress that the law does not reach, and for more than 100,000 steps of 1984, or such steps without
/// `update_of_1984`.
MaterialTestReport run_material_test(const Material& material, const MaterialTest& test,
                                     StressUpdate update_of_1984 = nullptr);

// The stress of a material in a first loading at constant rate.

/// Rates that the material was tested at, 1/s, increasing; at least one. Of a law without curves the ends of
/// its fitted range; without that, 1.
std::vector<double> tested_rates(const Material& material);

struct LoadingCurve {
  std::vector<double> strain;
  std::vector<double> stress;  ///< Pa
};

/// Up to a strain in (0, 1), in `steps` (2 or more) even steps from strain zero. The material
/// breaks no rule (violations(Material)).
LoadingCurve loading_curve(const Material& material, double rate, double strain, int steps);

}  // namespace dashpad::laboratory
