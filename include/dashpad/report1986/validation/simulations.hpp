#pragma once
/// The model's predictions for the validation tests.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

enum class Program {
  printed_1984,          ///< as printed, with its defects, pdp10 arithmetic, steps of 0.1 ms
  mended_support_1984,   ///< the same with the whole support curve (Defects::idle_segments mended)
  accurate,              ///< the solver, exact units, support as specified
  accurate_first_slope,  ///< the solver, with the load cell's first slope alone; on the plate the same as
                         ///< accurate
};
inline const std::vector<Program> programs{Program::printed_1984, Program::mended_support_1984,
                                           Program::accurate, Program::accurate_first_slope};
const char* to_string(Program program);  ///< for people: "1984 program", ...

/// The simulated impact: a projectile at a speed, with a nose radius, on one of the supports.
struct Setup {
  Projectile projectile = Projectile::aluminium;
  TestSupport support = TestSupport::load_cell;
  double speed_mph = 0;
  double radius_in = 0;
  friend bool operator==(const Setup&, const Setup&) = default;
};

Setup setup_of(const MeasuredTest& test, double radius_in);

/// The impact case of a setup: exact units, 9-parameter law of Ensolite (report, section 4).
ImpactCase impact_case(const ValidationData& data, const Material& ensolite, const Setup& setup);

/// Magnitudes in the report's units. A figure is absent if the run did not reach it. After an ABEND of the
/// program of 1984 the peaks are present if the projectile was on its way back and every step up to the peak
/// force was in equilibrium; the rebound speed is always absent.
struct Prediction {
  Program program = Program::accurate;
  Setup setup;
  std::optional<double> peak_force_lb;
  std::optional<double> time_to_peak_ms;
  std::optional<double> rebound_mph;  ///< at the weight criterion, the report's end of an impact
  std::optional<double> peak_strain;
  bool bottomed = false;    ///< the pad was fully compressed; accurate solver only
  double error = 0;         ///< estimated relative error of the peak force; 0 for the program of 1984
  std::string remark = {};  ///< why figures are missing or doubtful: an ABEND, a tolerance not met
};

/// The figures of an impact in the report's units. The caller sets program and setup.
Prediction figures_of(const Summary& summary);

/// Throws std::invalid_argument for a setup that makes no valid case (impact_case.hpp).
Prediction predict(const ValidationData& data, const Material& ensolite, Program program, const Setup& setup);

/// Receives the number of runs done and of all runs, after each run; one call at a time, from any thread.
using Progress = std::function<void(std::size_t, std::size_t)>;

/// Calls work(0) to work(count - 1) on all cores, and rethrows the first exception.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work, const Progress& progress);

/// One prediction for each setup and program, programs innermost, on all cores. Equal impacts are run once.
/// Throws what predict() throws.
std::vector<Prediction> predict_all(const ValidationData& data, const Material& ensolite,
                                    const std::vector<Program>& which, const std::vector<Setup>& setups,
                                    const Progress& progress = {});

/// The prediction of a program for a setup; null if there is none.
const Prediction* find(const std::vector<Prediction>& predictions, Program program, const Setup& setup);

}  // namespace dashpad::report1986
