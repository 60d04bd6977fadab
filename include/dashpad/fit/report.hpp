#pragma once
/// The results of a fit with their uncertainty. SI throughout.

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"

namespace dashpad::fit {

/// The result for one unknown.
struct FittedUnknown {
  std::string key;
  std::string unit;
  double value = 0;
  double lowest = 0, highest = 0;  ///< its bounds
  /// Standard error; absent at a bound, and where the data do not say anything of it.
  std::optional<double> standard_error;
  /// The 95 % interval by profile likelihood; an end is absent if the misfit does not rise enough.
  std::optional<double> low, high;
  /// Whether the model admits nothing beyond a bound, such as friction below 0: an interval may end there.
  bool lowest_is_natural = false, highest_is_natural = false;
  bool is_at_lowest = false, is_at_highest = false;
  bool is_logarithmic = false;            ///< sought by its logarithm
  std::optional<double> prior_deviation;  ///< deviation of its prior, if it has one
  bool is_added = false;                  ///< sought though the fit file does not name it
  /// Whether it belongs to a measurement: the shift of a force zero or of the clock of a pulse.
  bool is_nuisance = false;

  /// Whether its interval ends on both sides, or on one within the half next to a natural bound.
  [[nodiscard]] bool is_identified() const {
    const auto place = [this](double end) { return place_between(lowest, highest, is_logarithmic, end); };
    if (low && high) return true;
    if (high) return lowest_is_natural && place(*high) <= 0.5;
    return low && highest_is_natural && place(*low) >= 0.5;
  }
  /// Whether it lies at a bound beyond which the model continues.
  [[nodiscard]] bool wants_beyond() const {
    return (is_at_lowest && !lowest_is_natural) || (is_at_highest && !highest_is_natural);
  }
  /// Whether its prior says more of it than the data do: half of the variance of the prior is left.
  [[nodiscard]] bool rests_on_prior() const {
    return prior_deviation &&
           (!standard_error || 2 * *standard_error * *standard_error > *prior_deviation * *prior_deviation);
  }
  /// "no", "below", "above" or "both".
  [[nodiscard]] std::string open() const { return low ? (high ? "no" : "above") : (high ? "below" : "both"); }
};

/// A pair of unknowns whose errors are correlated by more than 0.95.
struct StrongCorrelation {
  std::string first, second;
  double value = 0;
};

/// A loading and the following unloading of a test.
struct Loop {
  double largest_strain = 0;
  double measured_return = 0;  ///< energy given back over energy taken in
  double computed_return = 0;
};

/// The comparison of the model with a test.
struct MetTest {
  std::string file;
  bool is_held_out = false;
  std::size_t points = 0;     ///< number of points that count
  double largest_stress = 0;  ///< Pa, measured
  double lowest_rate = 0;     ///< 1/s, magnitude, of the pieces between points that count
  double highest_rate = 0;
  double noise = 0;  ///< standard deviation that was used, Pa
  bool noise_is_stated = false;
  std::optional<double> offset;  ///< Pa, where it was fitted
  /// Root mean square of model minus measurement, Pa; absent where the test has no such part.
  std::optional<double> rms_loading, rms_unloading;
  std::vector<Loop> loops;
  double autocorrelation = 0;   ///< lag-1 rho of the residuals
  double effective_points = 0;  ///< n (1 - rho) / (1 + rho) where rho is clearly above 0, else n
  std::vector<double> strain, measured, computed;  ///< values at the points that count
  std::vector<int> course;                         ///< direction at each of them: 1 loading, -1 unloading
};

/// The comparison of the model with a figure of an impact.
struct MetFigure {
  std::string file;
  ImpactFigure figure = ImpactFigure::peak_force;
  bool is_held_out = false;
  double measured = 0, deviation = 0;
  std::optional<double> computed;  ///< absent where the impact has no such figure
  /// Standard deviation of the computed figure, by the uncertainty of the unknowns alone.
  std::optional<double> prediction_deviation;
};

/// The comparison of the model with a pulse of an impact.
struct MetPulse {
  std::string file;  ///< the case
  std::string pulse_file;
  bool is_held_out = false;
  std::size_t samples = 0;              ///< samples of the file between onset and end
  double deviation = 0;                 ///< m/s2
  double measured_peak = 0;             ///< m/s2
  std::optional<double> computed_peak;  ///< m/s2; absent where the impact has no whole pulse, as is rms
  std::optional<double> rms;            ///< m/s2, of model minus measurement
  /// s, by which the computed pulse comes later than with both onsets at one time; absent where held out.
  std::optional<double> shift;
  double autocorrelation = 0;
  double effective_points = 0;
  std::vector<double> time;                ///< s since the measured onset, of the points that were fitted
  std::vector<double> measured, computed;  ///< m/s2; nothing computed where there is no whole pulse
};

/// A figure for verdicts, measured and computed: peak, HIC and rebound speed of each pulse, then measured
/// figures that no pulse gives (peak_force, peak_acceleration, HIC, rebound_speed, peak_penetration). The
/// rebound speed of a pulse is its velocity change less the speed of the case and what gravity adds; it is
/// absent if that is not between 0 and the speed.
struct ImpactComparison {
  std::string file;  ///< the case
  ImpactFigure figure = ImpactFigure::peak_acceleration;
  bool is_held_out = false;        ///< predicted, not fitted
  bool is_of_pulse = false;        ///< taken from a pulse; else measured as a figure
  double measured = 0;             ///< SI, > 0
  std::optional<double> computed;  ///< with the filter of the pulse; absent if the impact has no such figure
  /// Standard deviation of what was measured, as stated; absent of a pulse, of which nobody states it.
  std::optional<double> deviation;

  /// The difference as a share of the measured value.
  [[nodiscard]] std::optional<double> share() const {
    return computed ? std::optional{(*computed - measured) / measured} : std::nullopt;
  }
};

/// A case with what was found of it.
struct FittedCase {
  ImpactCase impact;
  Options options;
};

struct FitReport {
  std::string title;
  bool converged = false;
  std::string why_not;  ///< if it did not converge
  Material material;    ///< the card, where it converged
  /// The case of the fit, or the first impact, with all fitted values; absent if the card holds them.
  std::optional<FittedCase> fitted_case;
  std::vector<FittedUnknown> unknowns;
  /// Ends of intervals that are rough, since the refits for each are bounded: "pad.curve.modulus, above".
  std::vector<std::string> rough_ends;
  std::vector<StrongCorrelation> correlations;
  std::vector<std::vector<std::string>> flat_directions;  ///< unknowns that are not told apart, or alone
  std::vector<MetTest> tests;
  std::vector<MetFigure> figures;
  std::vector<MetPulse> pulses;
  std::vector<ImpactComparison> comparison;  ///< in the order of the impacts
  std::vector<std::string> remarks;          ///< how files were read: "drop.csv: decimal commas were ..."
  std::size_t points = 0;                    ///< fitted residuals, without priors
  std::size_t priors = 0;
  double degrees_of_freedom = 0;
  double misfit = 0;             ///< sum of squared residuals over deviations, priors included
  bool noise_is_stated = false;  ///< whether all tests and impacts state it
  /// The factor on squared errors: the misfit per degree of freedom, at least 1, if all noise is stated; else
  /// 1, since the noise is estimated from the misfit.
  double variance_scale = 1;
  double largest_widening = 1;  ///< largest factor on a standard error from correlated residuals
  int starts = 0;
  int starts_at_best = 0;  ///< number of starts with the same misfit
  int starts_failed = 0;   ///< number of starts without a valid material or without convergence
  int solver_runs = 0;     ///< fixed number of solver runs per impact; 0 without impacts
  std::size_t evaluations = 0;
  double wall_time = 0;  ///< s
  /// A sample of the unknowns, in their order, if asked for.
  std::vector<std::vector<double>> posterior;

  [[nodiscard]] double misfit_per_degree() const {
    return degrees_of_freedom > 0 ? misfit / degrees_of_freedom : 0;
  }
};

struct RunOptions {
  std::size_t posterior = 0;  ///< draws of the unknowns to give
  /// Asked often: once it is true, run_fit() throws Stopped.
  const std::atomic<bool>* stop = nullptr;
  /// Told after each piece of work: what is going on, and how much of it is done. From any thread.
  std::function<void(const char* what, std::size_t done, std::size_t all)> progress = {};
  /// The file that keeps finished pieces for a later run of the same fit; empty to keep none.
  std::filesystem::path state = {};
  /// Tells this fit from others in that file.
  std::string fingerprint = {};
};

/// A fit was stopped on its way, by RunOptions::stop.
class Stopped : public std::runtime_error {
 public:
  explicit Stopped(std::size_t kept) : std::runtime_error("stopped"), kept_(kept) {}
  [[nodiscard]] std::size_t kept() const { return kept_; }  ///< pieces of work in the file of the state

 private:
  std::size_t kept_;
};

/// Throws std::runtime_error, with the file and the fault, if RunOptions::state names a file that is no
/// state, belongs to another fit or is damaged. run_fit() calls it.
void check_state(const Fit& fit, const RunOptions& options);

/// Fits. Throws std::invalid_argument with all violations() of the fit, and Stopped.
FitReport run_fit(const Fit& fit, const RunOptions& options = {});

}  // namespace dashpad::fit
