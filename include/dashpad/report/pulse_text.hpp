#pragma once
/// A pulse and its figures: as text for people, as JSON and CSV for programs, as a picture.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/injury/cfc_filter.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/io/unit_system.hpp"
#include "dashpad/measurement/measured_pulse.hpp"
#include "dashpad/report/plot.hpp"

namespace dashpad {

struct PulseFilter {
  int channel_frequency_class = 0;
  Corner corner = Corner::sae_j211;
  Ends ends = Ends::mirrored;
};

/// HIC with a window of one's own.
struct WindowedHic {
  double longest_window = 0;  ///< s
  Hic hic;
};

/// For how long the magnitude is above a level.
struct DwellTime {
  double level = 0;       ///< m/s2
  double cumulative = 0;  ///< s, all stretches
  double longest = 0;     ///< s, the longest stretch
};

/// A measured pulse, what was done to it, and what came of it.
struct PulseReport {
  std::string file;
  MeasuredPulse measured;
  std::optional<double> resampled_to;  ///< s
  std::optional<PulseFilter> filter;
  Pulse pulse;  ///< that of the figures
  InjuryFigures figures;
  std::vector<WindowedHic> windows;
  std::vector<DwellTime> dwells;
};

/// Resampled and filtered as asked for; the directions of a resultant each by itself, then combined. Throws
/// std::invalid_argument as resampled() and cfc_filtered() do.
Pulse processed_pulse(const MeasuredPulse& measured, std::optional<double> interval,
                      const std::optional<PulseFilter>& filter);

/// A remark if the pulse was sampled at less than ten times the class of the filter, as it was measured or as
/// it is resampled.
std::optional<std::string> sampled_too_slowly(const MeasuredPulse& measured, std::optional<double> interval,
                                              const PulseFilter& filter);

/// Peak, HIC, clips, severity index and velocity change, a line each; with ± where there is an error
/// estimate.
std::string injury_text(const InjuryFigures& figures, const UnitSystem& units);

/// Where the pulse came from, what was done to it, what was repaired, and all figures.
std::string pulse_text(const PulseReport& report, const UnitSystem& units);

/// The same in SI, accelerations in g.
std::string pulse_json(const PulseReport& report);

/// Time and acceleration of the pulse that the figures are of: "time_s,acceleration_g".
std::string pulse_csv(const PulseReport& report, const UnitSystem& units);

/// The pulse, before and after the filter, with the windows of HIC15 and HIC36 and the level of the 3 ms
/// clip.
Plot pulse_plot(const PulseReport& report, const UnitSystem& units);

}  // namespace dashpad
