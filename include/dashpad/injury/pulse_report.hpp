#pragma once
/// A measured pulse, what is done to it before its figures, and what it says of itself.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/pulse.hpp"
#include "dashpad/injury/cfc_filter.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

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

/// The sensor's offset and what it does to HIC.
struct OffsetEffect {
  SensorOffset offset;
  bool given = false;      ///< its interval; else the quiet part before the impact
  bool taken_off = false;  ///< from the pulse of the figures
  double hic15_with = 0, hic15_without = 0;
};

/// What a known impact speed v tells of a pulse: without friction and with the impactor free, its velocity
/// change lies between v (it stays) and 2 v (it rebounds as fast as it came).
struct MeasuredImpact {
  double speed = 0;                        ///< m/s, v, more than 0
  std::optional<double> drop_height = {};  ///< m, where v came from it
  /// m/s2, along the motion. It acts during contact too, and a sensor does not show it: the velocity changes
  /// by that much less a second than the integral of what the sensor shows.
  double gravity = 0;
};

/// v = sqrt(2 g h), of a free fall from `drop_height`, m, more than 0; g is standard gravity, also in
/// contact.
MeasuredImpact after_fall(double drop_height);

/// A stretch of a pulse from `begin` to `end`, s, both included.
struct Stretch {
  double begin = 0, end = 0;
};

/// The stretch in which the impactor touches what it strikes.
struct Contact {
  double begin = 0, end = 0;   ///< s
  double velocity_change = 0;  ///< m/s, over that stretch, magnitude
};

/// `along` is the acceleration along the axis of the impact, m/s2, of either sign: of a resultant that of its
/// main axis, since a length never changes its sign. Contact is the stretch around the peak above the level
/// of `quiet`, where nothing happens, or else the one that keeps the sign of the peak (docs/pulses.md).
/// Throws std::invalid_argument for what check() refuses.
Contact contact_of(const Pulse& along, const std::optional<Stretch>& quiet = {});

/// What sampling, filter and calibration leave open of a figure of a measured pulse.
///
/// Components and their sum are expanded uncertainties, k = 2 (some 95 %), relative to the figure. A bound b
/// on what sampling or a filter does counts as even between -b and b: its standard uncertainty is b / sqrt(3)
/// (GUM, JCGM 100:2008, 4.3.7).
struct FigureUncertainty {
  const ResultQuantity* quantity;
  std::optional<double> sampling = {};     ///< absent for a peak at an end, and for fewer than four samples
  std::optional<double> filter = {};       ///< absent where none was applied: what was before is not known
  std::optional<double> calibration = {};  ///< absent where nobody said it

  /// Root of the sum of the squares of those that are known.
  [[nodiscard]] double combined() const;
};

struct MeasurementUncertainty {
  std::optional<double> calibration = {};  ///< as stated: of an acceleration, expanded, relative
  std::string compared_with = {};          ///< "CFC1000" or "no filter", for the filter; empty without one
  std::vector<FigureUncertainty> figures;  ///< of peak, HIC, clips, velocity change, as far as known
};

/// A calibration is at most so much.
inline constexpr double max_calibration = 0.5;

/// A standard's limits beside the figures of a pulse.
struct PulseLimits {
  std::string standard;  ///< its title
  std::vector<CriterionResult> results;
  std::vector<Flag> reservations;  ///< about the limits
};

/// A measured pulse, what was done to it, and what came of it.
struct PulseReport {
  std::string file;
  /// What whoever measured says of it: "Position", "Date", and the words.
  std::vector<std::pair<std::string, std::string>> about;
  MeasuredPulse measured;
  std::optional<double> resampled_to;  ///< s
  std::optional<PulseFilter> filter;
  std::optional<OffsetEffect> offset;    ///< absent where there is no quiet part, and no interval was given
  Pulse pulse;                           ///< that of the figures
  Contact contact;                       ///< in it; of a resultant along its main axis
  InjuryFigures figures;                 ///< the velocity change is that over contact
  std::optional<MeasuredImpact> impact;  ///< where the speed is known
  std::vector<WindowedHic> windows;
  std::vector<DwellTime> dwells;
  std::vector<Flag> flags;
  MeasurementUncertainty uncertainty;
  std::optional<PulseLimits> limits;  ///< where it is laid beside a standard
};

struct ProcessedPulse {
  Pulse pulse;
  /// Of a resultant, along its main axis, which is its direction at the peak: a length never changes its
  /// sign.
  std::optional<Pulse> along_axis = {};

  [[nodiscard]] const Pulse& along() const { return along_axis ? *along_axis : pulse; }
};

/// Resampled and filtered as asked for; the directions of a resultant each by itself, then combined. Throws
/// std::invalid_argument as resampled() and cfc_filtered() do.
ProcessedPulse processed_pulse(const MeasuredPulse& measured, std::optional<double> interval,
                               const std::optional<PulseFilter>& filter);

/// m/s, of the velocity after and before: that over contact less what gravity gives meanwhile.
double change_of_motion(const Contact& contact, const MeasuredImpact& impact);

/// (change of motion - v) / v; absent where that is not between 0 and 1, to 0.1 % of the change: no body
/// rebounds like that, and IMPOSSIBLE VELOCITY CHANGE says so.
std::optional<double> restitution(const Contact& contact, const MeasuredImpact& impact);

/// PULSE CUT, where `pulse`, the processed one without the sensor's offset, starts or ends above its noise;
/// IMPOSSIBLE VELOCITY CHANGE, where that of the motion is not between v and 2 v; and height_in_doubt().
std::vector<Flag> flags(const PulseReport& report, const Pulse& pulse);

/// Velocities that differ by less count as the same, relative.
inline constexpr double rounding_of_velocity = 1e-3;

/// What the velocity change and a known impact speed v say of each other.
struct SpeedCheck {
  double change = 0;     ///< m/s, of the motion: change_of_motion()
  double shortfall = 0;  ///< m/s, by how much that is below v; above 2 v negative; 0 between them, to 0.1 %
  /// By what the accelerations may be multiplied for a change between v and 2 v; absent without acceleration.
  std::optional<double> min_scale = {}, greatest_scale = {};
  std::string text = {};  ///< a sentence

  [[nodiscard]] bool agrees() const { return shortfall == 0; }
};
/// Absent without an impact speed.
std::optional<SpeedCheck> speed_check(const PulseReport& report);

/// DROP HEIGHT IN DOUBT: the fall in the record, after a rest, takes another time than from that height, by
/// more than what 1 % of it and four samples at either end make.
std::optional<Flag> height_in_doubt(const PulseReport& report);

/// UNLIKE SPEEDS: the computed impact is at a speed more than 1 % off that of the measured one beside it.
std::optional<Flag> unlike_speeds(const MeasuredImpact& measured, const MeasuredImpact& computed);

/// Remarks if the offset changes HIC15 by more than 0.1 % and was not taken off, and if the interval that was
/// given for it is not quiet. `peak` is that of the pulse, m/s2.
std::vector<std::string> offset_remarks(const OffsetEffect& effect, double peak);

/// The figures of the pulse by the limits of a standard, each with the uncertainty of the measurement, k = 2,
/// as its error where that is known; lower bounds where the pulse is cut. Its dwells have the levels of the
/// standard.
PulseLimits within_limits(const PulseReport& report, const Standard& standard);

/// A remark if the pulse was sampled at less than ten times the class of the filter, as it was measured or as
/// it is resampled.
std::optional<std::string> sampled_too_slowly(const MeasuredPulse& measured, std::optional<double> interval,
                                              const PulseFilter& filter);

/// Of the figures of `report`, as docs/pulses.md has it. `calibration`: of an acceleration, expanded, in
/// (0, most_calibration), alike in all directions.
MeasurementUncertainty measurement_uncertainty(const PulseReport& report, std::optional<double> calibration);

// What is said of it in words and numbers.

/// "1.2, 0, -0.3 g", of accelerations in m/s2; 0 for what is 0 up to rounding, compared with the peak.
std::string each_in_g(const std::vector<double>& accelerations, double peak);

/// "12 %": two digits, and all digits before the point.
std::string in_percent(double fraction);

/// "HIC15 is 4.4 % higher with it than without".
std::string change_of_hic15(const OffsetEffect& effect);

}  // namespace dashpad::injury
