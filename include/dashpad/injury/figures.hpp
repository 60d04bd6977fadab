#pragma once
/// All injury figures of a pulse, and of a solved impact with their errors.

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

  /// Estimated relative errors of a solved impact; 0 for a pulse that is taken as it is.
  struct Errors {
    double peak = 0, hic15 = 0, hic36 = 0, hic_unlimited = 0, hic_d = 0, clip_3ms = 0, cumulative_3ms = 0,
           severity_index = 0, velocity_change = 0;
  } errors;
};

InjuryFigures injury_figures(const Pulse& pulse);

/// The power of the acceleration in a figure: 2.5 of each HIC and of the severity index, 1 of the others.
constexpr double acceleration_power(std::string_view key) {
  return key.starts_with("hic") || key == "severity_index" ? hic_power : 1;
}

/// A figure of a pulse as it is written: SI, with its relative error, and where it has its value.
struct InjuryValue {
  const ResultQuantity* quantity;
  double value = 0;
  double error = 0;
  std::optional<double> time = {};             ///< s, of a peak
  std::optional<double> begin = {}, end = {};  ///< s, of a window or stretch
};
/// All of them, for text, page and JSON alike.
std::array<InjuryValue, 9> injury_values(const InjuryFigures& injury_figures);
/// One of them; absent where the quantity is none of them.
std::optional<InjuryValue> injury_value(const InjuryFigures& injury_figures, const ResultQuantity& quantity);

/// The acceleration of the impactor. Until its end the history of an impact on a rigid support that bottomed
/// out is finite; it is no whole pulse.
Pulse pulse_of(const History& history);

/// The figures of pulse_of(solution.history). The errors add what the solver says of its forces and what is
/// left by the steps of the history, from a comparison with the run of twice the step.
InjuryFigures injury_figures(const Solution& solution);

/// Whether the history is that of a whole pulse, and finite: the impactor left the pad.
bool has_whole_pulse(const Solution& solution);

/// The same of a whole pulse; absent where it was cut off or is not finite: the impactor did not leave the
/// pad.
std::optional<InjuryFigures> whole_pulse_figures(const Solution& solution);

}  // namespace dashpad::injury
