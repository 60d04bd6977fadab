#pragma once
/// The injury figures of a pulse, and those of a solved impact with their errors.

#include <array>
#include <optional>
#include <string_view>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

struct InjuryFigures {
  Peak peak;
  Hic hic15, hic36, hic_unlimited;
  double hic_d = 0;
  Clip clip_3ms, cumulative_3ms;  ///< held for 3 ms without a break, and in all
  double severity_index = 0;
  double velocity_change = 0;  ///< m/s, magnitude

  /// Estimated relative errors for a solved impact; 0 for a given pulse.
  struct Errors {
    double peak = 0, hic15 = 0, hic36 = 0, hic_unlimited = 0, hic_d = 0, clip_3ms = 0, cumulative_3ms = 0,
           severity_index = 0, velocity_change = 0;
  } errors;
};

InjuryFigures injury_figures(const Pulse& pulse);

/// The exponent of the acceleration in a figure: 2.5 for HIC and the severity index, 1 for the others.
constexpr double acceleration_power(std::string_view key) {
  return key.starts_with("hic") || key == "severity_index" ? hic_power : 1;
}

/// An injury figure for output: SI, with its relative error and its time.
struct InjuryValue {
  const ResultQuantity* quantity;
  double value = 0;
  double error = 0;
  std::optional<double> time = {};             ///< s, of a peak
  std::optional<double> begin = {}, end = {};  ///< s, of a window or stretch
};
/// All figures, in one order for text, page and JSON.
std::array<InjuryValue, 9> injury_values(const InjuryFigures& injury_figures);
/// The figure of a quantity; absent if the quantity is no injury figure.
std::optional<InjuryValue> injury_value(const InjuryFigures& injury_figures, const ResultQuantity& quantity);

/// The acceleration of the impactor. For an impact that bottomed out on a rigid support it may end early or
/// contain values that are not finite.
Pulse pulse_of(const History& history);

/// The figures of pulse_of(solution.history), extrapolated by those of the run of twice the step (theory.md,
/// Eq. 31); windows and stretches are those of the history. The errors combine the solver's error of the
/// force with that of the time steps, two thirds of the difference of the two runs.
InjuryFigures injury_figures(const Solution& solution);

/// Whether the impactor left the pad and the history is finite.
bool has_whole_pulse(const Solution& solution);

/// The figures with their errors; absent if has_whole_pulse() is false.
std::optional<InjuryFigures> whole_pulse_figures(const Solution& solution);

}  // namespace dashpad::injury
