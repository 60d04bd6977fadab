#pragma once
/// What a reader must know before relying on a result.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Whether the force rose and fell: contact was lost, or the impactor came to rest, and nothing of the pulse
/// is missing. Otherwise HIC, clips, dwell times and the duration are those of a part of the pulse.
bool pulse_is_whole(const Summary& summary);

/// Whether the pad was fully compressed on what does not give way at once, where no force is finite; also
/// where the tolerance was missed on the way there.
bool bottomed_on_rigid_support(const Summary& summary);

/// Whether the run ends before the pulse does, but for a pad that bottomed out: the largest values are those
/// of a part of the impact.
bool is_cut(const Summary& summary);

/// Whether a blow says what the next one would meet: it ended, its penetration is reliable, and it did not
/// close the pad, beyond which no curve goes.
bool leaves_a_known_pad(const Summary& summary);

/// Whether a series of blows ends with this one, though more were asked for.
bool is_series_cut(const Summary& summary);

/// Whether the pad and the support gave back more energy than they took, by more than the error estimates.
bool gained_energy(const Summary& summary);

/// What a flag means for the figures beside it.
enum class Severity {
  unusable,  ///< they are not an answer
  doubtful,  ///< they may be off by more than their estimates and intervals, or are those of a part
  note       ///< they stand, and something about them has to be known
};
/// "unusable", "doubtful", "note".
const char* to_string(Severity severity);

struct FlagKind {
  const char* name;
  Severity severity;
};
/// Every flag of a result, of a measured pulse and of a material test.
std::span<const FlagKind> flag_kinds();
/// Doubtful for a name that is none of them.
Severity severity_of(std::string_view name);

/// A number that a flag speaks of.
struct FlagFigure {
  std::string key;  ///< with its SI unit: "time_s", "energy_gained_fraction"
  double value;
};

struct Flag {
  std::string name;  ///< of flag_kinds()
  std::string text;  ///< a line that begins with the name
  std::vector<FlagFigure> figures = {};
};
/// The flag whose text is its name, a colon and these words.
Flag flag_of(const std::string& name, std::string_view words, std::vector<FlagFigure> figures = {});

/// What a person decides by where no standard says it.
const std::vector<std::string>& usual_figures();

/// None for a result without reservations. EXTRAPOLATED ... comes once for each reason, and where intervals
/// were found only if what lies beyond the tests moves one of the `decisive` figures by more than 1 %, with
/// how much. A pad that bottomed out on a rigid support is BOTTOMED, not PULSE CUT.
std::vector<Flag> flags(const Summary& summary, const std::vector<std::string>& decisive = usual_figures());

}  // namespace dashpad
