#pragma once
/// Evaluation of a measured pulse: its processing, figures and checks.

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

/// HIC with a window of the user's choice.
struct WindowedHic {
  double longest_window = 0;  ///< s
  Hic hic;
};

/// The time during which the magnitude exceeds a level.
struct DwellTime {
  double level = 0;       ///< m/s2
  double cumulative = 0;  ///< s, all stretches together
  double longest = 0;     ///< s, the longest stretch
};

/// The sensor's offset and its effect on HIC.
struct OffsetEffect {
  SensorOffset offset;
  bool given = false;      ///< for an interval given by the user; else for the quiet part before the impact
  bool taken_off = false;  ///< subtracted from the pulse of the figures
  double hic15_with = 0, hic15_without = 0;
};

/// A known impact speed v. Without friction and with a free impactor, the velocity change lies between v (no
/// rebound) and 2 v (rebound at the impact speed).
struct MeasuredImpact {
  double speed = 0;                        ///< m/s, v, more than 0
  std::optional<double> drop_height = {};  ///< m, if v follows from it
  /// m/s2, along the motion. It acts during contact without being measured by the sensor: per second, the
  /// velocity changes by that much less than the integral of the measured acceleration.
  double gravity = 0;
};

/// The impact after a free fall from `drop_height`, m, > 0: v = sqrt(2 g h), with standard gravity, also
/// during contact.
MeasuredImpact after_fall(double drop_height);

struct Stretch {
  double begin = 0, end = 0;
};

/// The stretch during which the impactor is in contact.
struct Contact {
  double begin = 0, end = 0;   ///< s
  double velocity_change = 0;  ///< m/s, over that stretch, magnitude
};

/// The contact of a pulse. `along` is the acceleration along the axis of the impact, m/s2, of either sign;
/// for a resultant along its main axis, since a magnitude never changes sign. Contact is the stretch around
/// the peak above the level of `quiet`, or, without it, where the sign is that of the peak (docs/pulses.md).
/// Throws std::invalid_argument for a pulse that check() refuses.
Contact contact_of(const Pulse& along, const std::optional<Stretch>& quiet = {});

/// The uncertainty of a figure of a measured pulse due to sampling, filter and calibration.
///
/// Components and total are expanded uncertainties, k = 2 (about 95 %), relative to the figure. A bound b on
/// an effect is taken as a uniform distribution from -b to b, with the standard uncertainty b / sqrt(3) (GUM,
/// JCGM 100:2008, 4.3.7).
struct FigureUncertainty {
  const ResultQuantity* quantity;
  std::optional<double> sampling = {};     ///< absent for a peak at an end, and for fewer than four samples
  std::optional<double> filter = {};       ///< absent without a filter: earlier filtering is unknown
  std::optional<double> calibration = {};  ///< absent unless stated

  /// Root of the sum of squares of the known components.
  [[nodiscard]] double combined() const;
};

struct MeasurementUncertainty {
  std::optional<double> calibration = {};  ///< as stated: expanded relative uncertainty of an acceleration
  std::string compared_with = {};          ///< "CFC1000" or "no filter", for the filter; empty without one
  std::vector<FigureUncertainty> figures;  ///< of peak, HIC, clips, velocity change, as far as known
};

/// Upper limit of a stated calibration.
inline constexpr double max_calibration = 0.5;

/// The limits of a standard applied to the figures of a pulse.
struct PulseLimits {
  std::string standard;  ///< its title
  std::vector<CriterionResult> results;
  std::vector<Flag> reservations;  ///< about the limits
};

/// A measured pulse with its processing and its results.
struct PulseReport {
  std::string file;
  /// Remarks of the user: "Position", "Date", and their texts.
  std::vector<std::pair<std::string, std::string>> about;
  MeasuredPulse measured;
  std::optional<double> resampled_to;  ///< s
  std::optional<PulseFilter> filter;
  std::optional<OffsetEffect> offset;    ///< absent without a quiet part or a given interval
  Pulse pulse;                           ///< that of the figures
  Contact contact;                       ///< in `pulse`; for a resultant along its main axis
  InjuryFigures figures;                 ///< the velocity change is that over contact
  std::optional<MeasuredImpact> impact;  ///< if the speed is known
  std::vector<WindowedHic> windows;
  std::vector<DwellTime> dwells;
  std::vector<Flag> flags;
  MeasurementUncertainty uncertainty;
  std::optional<PulseLimits> limits;  ///< if a standard was chosen
};

struct ProcessedPulse {
  Pulse pulse;
  /// For a resultant, the pulse along its main axis, which is its direction at the peak.
  std::optional<Pulse> along_axis = {};

  [[nodiscard]] const Pulse& along() const { return along_axis ? *along_axis : pulse; }
};

/// Resamples and filters as requested. The directions of a resultant are processed separately and then
/// combined. Throws as resampled() and cfc_filtered() do.
ProcessedPulse processed_pulse(const MeasuredPulse& measured, std::optional<double> interval,
                               const std::optional<PulseFilter>& filter);

/// The treatment of a pulse before its figures are computed, and the figures beyond the usual ones.
struct PulseTreatment {
  std::optional<double> resample_to = {};  ///< s
  std::optional<PulseFilter> filter = {};
  std::optional<SensorOffset> offset = {};  ///< of find_offset()
  bool offset_is_given = false;             ///< for an interval given by the user
  bool subtracts_offset = false;
  std::vector<double> windows = {};             ///< s, of further HICs
  std::vector<double> levels = {};              ///< m/s2, of dwell times
  const Standard* standard = nullptr;           ///< whose levels are added
  std::optional<MeasuredImpact> impact = {};    ///< with a known speed
  std::optional<MeasuredImpact> computed = {};  ///< with which the pulse is compared
};

/// The pulse of `file` with its figures, remarks and flags. Throws as processed_pulse() does.
PulseReport evaluate_pulse(std::string file, MeasuredPulse measured, const PulseTreatment& treatment);

/// The change of velocity of the body, m/s: that over contact minus the effect of gravity.
double change_of_motion(const Contact& contact, const MeasuredImpact& impact);

/// (change of motion - v) / v; absent unless that is between 0 and 1, to 0.1 % of the change. Otherwise the
/// flag IMPOSSIBLE VELOCITY CHANGE is set.
std::optional<double> restitution(const Contact& contact, const MeasuredImpact& impact);

/// PULSE CUT, if `pulse` (processed, without the sensor's offset) starts or ends above its noise; IMPOSSIBLE
/// VELOCITY CHANGE, if the change of motion is not between v and 2 v; and height_in_doubt().
std::vector<Flag> flags(const PulseReport& report, const Pulse& pulse);

/// Velocities whose relative difference is smaller are equal.
inline constexpr double rounding_of_velocity = 1e-3;

/// Comparison of the velocity change with a known impact speed v.
struct SpeedCheck {
  double change = 0;     ///< m/s, of the motion: change_of_motion()
  double shortfall = 0;  ///< m/s, how much it is below v, or negative above 2 v; 0 in between, to 0.1 %
  /// The factors of the acceleration for a change of v and of 2 v; absent without acceleration.
  std::optional<double> min_scale = {}, greatest_scale = {};
  std::string text = {};  ///< a sentence

  [[nodiscard]] bool agrees() const { return shortfall == 0; }
};
/// Absent without an impact speed.
std::optional<SpeedCheck> speed_check(const PulseReport& report);

/// DROP HEIGHT IN DOUBT: in a record with a rest and a fall, the duration of the fall does not match the
/// stated height, to within 1 % and four samples at either end.
std::optional<Flag> height_in_doubt(const PulseReport& report);

/// UNLIKE SPEEDS: the speeds of the computed and the measured impact differ by more than 1 %.
std::optional<Flag> unlike_speeds(const MeasuredImpact& measured, const MeasuredImpact& computed);

/// Remarks if the offset changes HIC15 by more than 0.1 % and was not subtracted, and if its given interval
/// is not quiet. `peak` is that of the pulse, m/s2.
std::vector<std::string> offset_remarks(const OffsetEffect& effect, double peak);

/// Applies the limits of a standard to the figures. The error of a result is the uncertainty of the
/// measurement, k = 2, if it is known; figures of a cut pulse are lower bounds. `report` must have dwell
/// times at the levels of the standard.
PulseLimits within_limits(const PulseReport& report, const Standard& standard);

/// Remarks if the sampling frequency, measured or resampled, is less than ten times the filter's class, and
/// if a channel's code says that it was filtered before.
std::vector<std::string> filter_remarks(const MeasuredPulse& measured, std::optional<double> interval,
                                        const PulseFilter& filter);

/// The interval, s, at which uneven samples are resampled for a filter, with a remark; absent for even ones.
std::optional<double> resampling_for_filter(MeasuredPulse& measured);

/// The uncertainties of the figures of `report` (docs/pulses.md). `calibration`: expanded relative
/// uncertainty of an acceleration, in (0, max_calibration), equal in all directions.
MeasurementUncertainty measurement_uncertainty(const PulseReport& report, std::optional<double> calibration);

// Wording of the figures.

/// "1.2, 0, -0.3 g", for accelerations in m/s2; 0 if negligible compared with the peak.
std::string each_in_g(const std::vector<double>& accelerations, double peak);

/// "12 %": two digits, and all digits before the decimal point.
std::string in_percent(double fraction);

/// "HIC15 is 4.4 % higher with the offset than without".
std::string change_of_hic15(const OffsetEffect& effect);

}  // namespace dashpad::injury
