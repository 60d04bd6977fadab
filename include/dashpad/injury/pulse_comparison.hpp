#pragma once
/// Comparison of a measured pulse with the computed one of an impact.
///
/// Differences are computed minus measured, in SI; shares are relative to the measured figure. Each pulse is
/// turned so that its peak is positive.

#include <array>
#include <optional>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

/// The points that are made to coincide in time, since the zero of a measured time is arbitrary.
enum class Alignment {
  onset,  ///< the onsets: where each pulse first reaches onset_share of its own peak
  peak,   ///< the peaks
  none,   ///< none: computed times count from first contact, measured times as in the file
};
/// "onset", "peak", "none".
const char* to_string(Alignment alignment);
inline constexpr std::array all_alignments{Alignment::onset, Alignment::peak, Alignment::none};

/// Share of the peak at which a pulse has its onset.
inline constexpr double onset_share = 0.05;

/// The figures of one pulse for the comparison.
struct PulseShape {
  Peak peak;
  double side = 1;  ///< 1 or -1: the sign of the acceleration at the peak
  /// s, when |a| first reaches onset_share of its peak; absent if the first sample is already there.
  std::optional<double> onset;
  /// s, when it does so for the last time before its peak: later than the onset if noise gets there earlier.
  std::optional<double> last_onset;
  double width = 0;  ///< s, total time with |a| above half the peak
  Contact contact;
  double hic15 = 0;  ///< g^2.5 s, over the whole pulse
  /// (change of motion - v) / v for an impact speed v. Absent without v, or if the change is not between v
  /// and 2 v, to 0.1 %.
  std::optional<double> restitution;
};

/// `contact` defaults to contact_of(pulse). Throws std::invalid_argument for a pulse that check() refuses or
/// whose acceleration is zero throughout.
PulseShape pulse_shape(const Pulse& pulse, const std::optional<MeasuredImpact>& impact,
                       const std::optional<Contact>& contact = {});

/// Throws std::invalid_argument if the pulse has no onset to align.
void check_alignment(const PulseShape& measured, Alignment alignment);

/// One figure of both pulses, SI.
struct ComparedFigure {
  const ResultQuantity* quantity;
  std::optional<double> measured, computed;
  double error = 0;  ///< estimated relative error of the computed figure

  [[nodiscard]] std::optional<double> difference() const {
    return measured && computed ? std::optional{*computed - *measured} : std::nullopt;
  }
  /// The difference relative to the measured figure; absent unless that is positive.
  [[nodiscard]] std::optional<double> share() const {
    return difference() && *measured > 0 ? std::optional{*difference() / *measured} : std::nullopt;
  }
};

/// Peak, time to peak, width, velocity change, HIC15 and restitution. The time to the peak counts from the
/// onset, or without alignment from the zero of each pulse. Errors are left at 0.
std::array<ComparedFigure, 6> compared_figures(const PulseShape& measured,
                                               const std::optional<PulseShape>& computed,
                                               Alignment alignment);

struct PulseComparison {
  Alignment alignment = Alignment::onset;
  double shift = 0;  ///< s, to be added to the measured times
  PulseShape measured;
  Pulse computed_pulse;                ///< with the filter of the measured one; may have no samples
  std::optional<PulseShape> computed;  ///< absent if the computed pulse is not whole
  std::array<ComparedFigure, 6> figures;
};

/// A computed pulse, filtered like a measured one whose samples are `interval` s apart, with free flight
/// before and after; unchanged without a filter. Throws as cfc_filtered() does.
Pulse filtered_like(const std::optional<PulseFilter>& filter, double interval, const Pulse& pulse);

/// Compares the pulse of `report` with that of `solution`, the solution of `impact`, by filtered_like().
/// Throws as pulse_shape(), check_alignment() and cfc_filtered() do.
PulseComparison compare_pulses(const PulseReport& report, const Solution& solution,
                               const MeasuredImpact& impact, Alignment alignment);

}  // namespace dashpad::injury
