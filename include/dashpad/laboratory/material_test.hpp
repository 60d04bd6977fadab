#pragma once
/// Simulated tests of a pad material: a column led through a test at several strain rates, and the figures
/// that follow. docs/laboratory.md explains tests and figures.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "dashpad/model/pad/material.hpp"

namespace dashpad::laboratory {

/// Cushioning by a foam in its first loading (Miltz and Gruenbaum 1981; Avalle et al. 2001): energy W per
/// volume up to a strain, and the largest stress S so far.
///
///   W = integral of stress over strain,   efficiency = W / S,   ideality = W / (S strain)
///
/// A foam is used best at the stress of the highest efficiency. W is the work of the test, whatever the
/// number of places. There is one entry for each place of output at which the strain, > 0, has grown.
struct CushionCurve {
  std::vector<double> strain;
  std::vector<double> stress;      ///< S, Pa
  std::vector<double> energy;      ///< W, J/m3
  std::vector<double> efficiency;  ///< W / S
  std::vector<double> ideality;    ///< W / (S strain)
};
CushionCurve cushion_curve(const ColumnTest& test);

/// A point of a cushion curve.
struct CushionPoint {
  double strain = 0;
  double stress = 0;  ///< Pa
  double energy = 0;  ///< J/m3
  double efficiency = 0;
  double ideality = 0;
};

struct CushionFigures {
  double peak_stress = 0;        ///< Pa; between places of output by a parabola
  double strain_at_peak = 0;     ///< strain at which it is first reached, not always the largest
  double energy_in = 0;          ///< energy while the strain grew, in all cycles, J/m3
  double energy_returned = 0;    ///< energy while it fell, J/m3
  double hysteresis = 0;         ///< (in - returned) / in, from 0 to 1, or below 0 if more came back
  CushionPoint best_efficiency;  ///< point of the highest W / S
  double energy_error = 0;       ///< estimated error of the energies, as a fraction of energy_in
};
CushionFigures cushion_figures(const ColumnTest& test);

/// The energy that a foam absorbs up to a stress: the point of the first loading at which the stress first
/// reaches `limit`, Pa, > 0 (std::invalid_argument otherwise). Nothing if the test never reaches it.
///
/// Between places ln(stress) is the cubic in ln(strain) through the nearest four, before the first a power of
/// the strain. With 200 places the strain of the Ensolite laws is right to 1e-6, the energy to 1e-5.
std::optional<CushionPoint> at_stress_limit(const CushionCurve& curve, double limit);

enum class TestKind {
  constant_rate,  ///< loading and unloading at constant rate (report, Eq. 29)
  parabolic,      ///< loading and unloading on a parabola (report, Eq. 30)
  relaxation,     ///< loading at constant rate, then a hold at that strain
  creep,          ///< loading at constant rate, then a hold at a stress
  cyclic,         ///< cycles between two strains
  history,        ///< a measured strain history
};
inline constexpr TestKind all_test_kinds[] = {TestKind::constant_rate, TestKind::parabolic,
                                              TestKind::relaxation,    TestKind::creep,
                                              TestKind::cyclic,        TestKind::history};
/// The name on the command line: "constant-rate" and so on.
const char* to_string(TestKind kind);

/// A test. Strains are engineering values, compression positive, in [0, 1).
struct MaterialTest {
  TestKind kind = TestKind::constant_rate;
  std::vector<double> rates = {1, 100};           ///< loading rates, 1/s, > 0; unused by a measured history
  double strain = 0.95;                           ///< largest strain; unused by creep and a measured history
  double hold = 1;                                ///< duration of the hold, s, > 0: relaxation and creep
  double stress = 0;                              ///< stress of creep, Pa, > 0
  double low = 0;                                 ///< strain at which the unloading of a cycle ends, < strain
  int cycles = 3;                                 ///< 1 to 1000
  std::string history_name = {};                  ///< source of a measured history
  std::vector<std::string> history_remarks = {};  ///< remarks on how it was read
  std::vector<double> times = {};                 ///< times of a measured history, s
  std::vector<double> strains = {};               ///< strains of a measured history
  std::vector<double> stress_limits = {};         ///< stresses for which cushioning is reported, Pa, > 0
  /// Number of steps in the first loading of the update of 1984, 1 to 10,000; none by default; not for creep.
  std::optional<int> steps_of_1984 = {};
};

/// Stresses at the end of the first loading, Pa.
struct StressAtTurn {
  double last_loading = 0;
  double next = 0;  ///< stress one step of the update of 1984 later
  [[nodiscard]] double jump() const { return next - last_loading; }
};

/// The update of 1984 (report, Eq. 16) on the same history, in the arithmetic of its machine.
struct UpdateOf1984 {
  double step = 0;                ///< duration of the first loading over the number of steps, s
  std::vector<double> time = {};  ///< s
  std::vector<double> strain = {};
  std::vector<double> stress = {};  ///< Pa
  std::vector<double> exact = {};   ///< exact stress at the same times, Pa
  /// Absent if the test ends with its first loading. A jump above 0 is the stress-discontinuity artifact.
  std::optional<StressAtTurn> update_at_turn = {}, exact_at_turn = {};
};

/// Shares of the exact peak stress outside which stresses of 1984 are flagged as OUT OF BOUNDS and not drawn.
inline constexpr double lowest_drawn = -0.1, highest_drawn = 1.5;

/// Stress relaxation, Pa.
struct RelaxedStress {
  double at_end_of_ramp = 0;
  double after_tenth = 0;  ///< stress after a tenth of the hold
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
  bool unloads = false;                                ///< whether energy can be returned
  std::vector<std::optional<CushionPoint>> at_limits;  ///< for each stress limit; absent if not reached
  std::optional<RelaxedStress> relaxed;
  std::optional<CreptStrain> crept;
  std::optional<UpdateOf1984> update_of_1984;
  std::vector<Flag> flags;  ///< EXTRAPOLATED, ASSUMPTION, ENERGY GAIN, OUT OF BOUNDS
};

struct MaterialTestReport {
  Material material;
  MaterialTest test;
  std::vector<MaterialTestRun> runs = {};  ///< one for each rate
};

/// A function that returns the stresses of a column, Pa, by an explicit update at strains `step` s apart, the
/// first of them 0: spit1984::stresses_of_update.
using StressUpdate = std::vector<double> (*)(const Material& material, const std::vector<double>& strains,
                                             double step);

/// Runs the test. Throws std::invalid_argument for violations() of law or history, for a creep stress that
/// the law does not reach, and for steps of 1984 above 100,000 or without `update_of_1984`.
///
/// Example:
/// \code
/// #include "dashpad/input/case_file.hpp"
/// const auto foam = dashpad::input::read_material("materials/vn600.toml").value();
/// const auto report = dashpad::laboratory::run_material_test(foam, {.rates = {1, 100}, .strain = 0.6});
/// for (const dashpad::laboratory::MaterialTestRun& run : report.runs)
///   std::printf("%.0f kPa, %.0f %% lost\n", 1e-3 * run.figures.peak_stress, 100 * run.figures.hysteresis);
/// \endcode
MaterialTestReport run_material_test(const Material& material, const MaterialTest& test,
                                     StressUpdate update_of_1984 = nullptr);

/// Rates of the tests of the material, 1/s, increasing, at least one. For a law without curves these are the
/// ends of its fitted range; without that, 1.
std::vector<double> tested_rates(const Material& material);

struct LoadingCurve {
  std::vector<double> strain;
  std::vector<double> stress;  ///< Pa
};

/// Stress of a material in a first loading at constant rate, up to a strain in (0, 1), at `steps` (2 or more)
/// even steps from strain zero. The material must have no violations().
LoadingCurve loading_curve(const Material& material, double rate, double strain, int steps);

}  // namespace dashpad::laboratory
