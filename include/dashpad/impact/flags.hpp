#pragma once
/// Flags: the reservations that go with a result.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Whether the pulse is complete, after release or rest; else HIC, clips and durations are those of a part.
bool pulse_is_whole(const Summary& summary);

/// Whether the pad was fully compressed on a support that does not yield at once, so that the force has no
/// finite value; true even if the tolerance was missed before.
bool bottomed_on_rigid_support(const Summary& summary);

/// Whether the run ends before the pulse, except by bottoming on a rigid support; peaks are then partial.
bool is_cut(const Summary& summary);

/// Whether the state of the pad after a blow is known: contact was lost, the penetration is reliable, and the
/// pad was not closed, beyond which no curve extends.
bool leaves_a_known_pad(const Summary& summary);

/// Whether a series of blows ends early with this one.
bool is_series_cut(const Summary& summary);

/// Whether the pad gave back more energy than it took, by more than the error estimate and the residual.
bool gained_energy(const Summary& summary);

/// Effect of a flag on the figures of its result.
enum class Severity {
  unusable,  ///< the figures are no answer
  doubtful,  ///< their errors may exceed estimates and intervals, or they are those of a part
  note       ///< they are valid, with a remark
};
/// "unusable", "doubtful", "note".
const char* to_string(Severity severity);

struct FlagKind {
  const char* name;
  Severity severity;
};
/// Every flag of a result, a measured pulse, an assessment and a material test.
std::span<const FlagKind> flag_kinds();
/// Severity of the flag with that name; doubtful for an unknown name.
Severity severity_of(std::string_view name);

/// A number that a flag mentions.
struct FlagFigure {
  std::string key;  ///< with its SI unit: "time_s", "energy_gained_fraction"
  double value;
};

struct Flag {
  std::string name;  ///< name in flag_kinds()
  std::string text;  ///< a line that begins with the name
  std::vector<FlagFigure> figures = {};
};
/// A flag with the text "`name`: `words`".
Flag flag_of(const std::string& name, std::string_view words, std::vector<FlagFigure> figures = {});

/// The largest relative change of a figure that the flag states; 0 if it states none.
double largest_effect(const Flag& flag);

/// Keys of the figures that decide about an impact where no standard names others.
const std::vector<std::string>& usual_figures();

/// Flags of a result; none if there is no reservation. EXTRAPOLATED ... appears once for each reason, that
/// with an unknown or the largest effect first; if there are intervals, only where the extrapolation moves
/// one of the `decisive` figures by more than 1 %, which the text then states. A pad that bottomed out on a
/// rigid support is BOTTOMED, not PULSE CUT.
std::vector<Flag> flags(const Summary& summary, const std::vector<std::string>& decisive = usual_figures());

}  // namespace dashpad
