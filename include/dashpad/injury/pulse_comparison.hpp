#pragma once
/// A measured pulse laid over the computed one of an impact, and the differences between them.
///
/// Differences are computed less measured, in SI; their shares are of the measured figure. The sign of an
/// acceleration does not count: each pulse is turned so that its peak is positive.

#include <array>
#include <optional>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

/// The zero of a measured time is arbitrary. What is made to coincide in time:
enum class Alignment {
  onset,  ///< the onsets: where each pulse first reaches onset_share of its own peak
  peak,   ///< the peaks
  none,   ///< nothing: computed times count from first contact, measured times as in the file
};
/// "onset", "peak", "none".
const char* to_string(Alignment alignment);
inline constexpr std::array all_alignments{Alignment::onset, Alignment::peak, Alignment::none};

/// Share of the peak at which a pulse has its onset.
inline constexpr double onset_share = 0.05;

/// The figures of one pulse that are compared.
struct PulseShape {
  Peak peak;
  double side = 1;  ///< 1 or -1: the sign of the acceleration at the peak
  /// s, when |a| first reaches onset_share of its peak; absent where the first sample is there already.
  std::optional<double> onset;
  /// s, when it does so for the last time before its peak: later than the onset where noise or an offset
  /// reaches that level before the impact.
  std::optional<double> last_onset;
  double width = 0;  ///< s, all time with |a| above half the peak
  Contact contact;
  double hic15 = 0;  ///< g^2.5 s, over the whole pulse
  /// (change of motion - v) / v for an impact speed v; absent without v, and where that change is not between
  /// v and 2 v, to 0.1 %: then the pulse does not show it.
  std::optional<double> restitution;
};

/// `contact`: where it is known; else contact_of(pulse). Throws std::invalid_argument for what check()
/// refuses, and for a pulse without any acceleration.
PulseShape pulse_shape(const Pulse& pulse, const std::optional<MeasuredImpact>& impact,
                       const std::optional<Contact>& contact = {});

/// Throws std::invalid_argument where the pulse has no onset to align.
void check_alignment(const PulseShape& measured, Alignment alignment);

/// A figure of both pulses, SI.
struct ComparedFigure {
  const ResultQuantity* quantity;
  std::optional<double> measured, computed;
  double error = 0;  ///< estimated, of the computed figure, relative

  [[nodiscard]] std::optional<double> difference() const;
  /// Of the measured figure; absent where that is not positive.
  [[nodiscard]] std::optional<double> share() const;
};

/// Peak, time to peak, width, velocity change, HIC15, restitution. The time to the peak counts from the
/// onset; without alignment, from the zero of each pulse. Errors are left at 0.
std::array<ComparedFigure, 6> compared_figures(const PulseShape& measured,
                                               const std::optional<PulseShape>& computed,
                                               Alignment alignment);

struct PulseComparison {
  Alignment alignment = Alignment::onset;
  double shift = 0;  ///< s, to add to the measured times
  PulseShape measured;
  Pulse computed_pulse;  ///< as it is compared, with the filter of the measured one; may have no samples
  std::optional<PulseShape> computed;  ///< absent where the computed pulse is not whole
  std::array<ComparedFigure, 6> figures;
};

/// A computed pulse as it is laid beside a measured one that went through `filter` and whose samples lie
/// `interval` s apart: filtered likewise, with free flight before and after; as it is without filter. Throws
/// as cfc_filtered() does.
Pulse filtered_like(const std::optional<PulseFilter>& filter, double interval, const Pulse& pulse);

/// The pulse of `report` beside that of `solution`, which is of `impact`. The computed pulse gets the
/// filter of the measured one, at the same interval of samples, with free flight before and after it. Throws
/// as pulse_shape(), check_alignment() and cfc_filtered() do.
PulseComparison compare_pulses(const PulseReport& report, const Solution& solution,
                               const MeasuredImpact& impact, Alignment alignment);

}  // namespace dashpad::injury
