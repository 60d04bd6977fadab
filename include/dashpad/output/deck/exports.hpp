#pragma once
/// Curves of a solved impact as text for other programs. The files state their origin, units and signs.
///
/// Text from users cannot break a file: it becomes printable ASCII, stands only after fixed words, and is
/// folded or cut to the width of a line.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

struct CurveAxis {
  std::string meaning;  ///< "time"
  std::string si_unit;  ///< "s"
};

/// y over x, with x strictly increasing in steps of at least smallest_gap of the largest x.
struct Curve {
  std::string name;  ///< one of curve_names()
  CurveAxis abscissa;
  CurveAxis ordinate;
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// A single point is no curve to any program.
  [[nodiscard]] bool exists() const { return x.size() >= 2; }
};

/// Smallest step in x, relative to the largest x. Points that are nearer could not be told apart in single
/// precision, in which some decks are solved; they are omitted.
inline constexpr double smallest_gap = 1e-6;

/// Greatest width of the stretch over which a sudden fall of the force is spread, relative to the largest
/// penetration, so that the force stays a function of the penetration.
inline constexpr double widest_fall = 1e-3;

/// force, acceleration, velocity, motion, penetration: over time. loading, unloading: force over penetration.
const std::vector<std::string>& curve_names();

/// The curve of that name, with the signs of History. Throws std::invalid_argument for an unknown name.
Curve curve(const std::string& name, const Solution& solution);

/// Force over penetration from first contact to the largest penetration. Each penetration has the force at
/// which it was first reached: points where the pad is held or springs back are omitted. On a yielding
/// support the curve ends when the pad is fully compressed, since the force beyond belongs to the support.
Curve loading_branch(const History& history);

/// Force over penetration from the largest penetration back to release, in order of increasing penetration.
/// Each penetration has the force at which it was last passed; below that of release the force is 0, and at
/// the largest penetration it is that of the loading branch. A fall of the force at the largest penetration
/// is spread over the last widest_fall of it, or over half the way to the previous point if that is less.
/// Does not exist if the impactor was not released.
Curve unloading_branch(const Solution& solution);

struct ThinnedCurve {
  Curve curve;
  double error = 0;  ///< largest difference in y from the given curve, both being linear between points
};

/// At most `max_points` (2 or more) points of the curve: its ends, then repeatedly the one furthest off.
ThinnedCurve thinned(const Curve& curve, std::size_t max_points);

struct FileCurve {
  Curve curve;         ///< SI
  std::string remark;  ///< how it was thinned, or why it does not exist
};

struct CurveFile {
  std::string title;                ///< of the case
  std::vector<std::string> origin;  ///< what strikes what
  std::vector<std::string> flags;   ///< warnings about the curves
  std::vector<FileCurve> curves;    ///< numbered from first_id; curves that do not exist keep their numbers
  UnitSystem units = consistent_systems().front();
  bool acceleration_in_g = false;
  int first_id = 1;
};

/// Some places of LS-DYNA allow less; 8 digits leave a blank in a field of 10.
inline constexpr int highest_curve_id = 99'999'999;

/// The flags of a result, a line each (dashpad/impact/flags.hpp), with their consequences for the curves.
std::vector<std::string> flags_of(const Summary& summary);

/// The curves of those names with title, origin and flags, thinned to `max_points` if given. Throws
/// std::invalid_argument for a name that is not one of curve_names().
CurveFile curve_file(const ImpactCase& impact, const Solution& solution,
                     const std::vector<std::string>& names, std::optional<std::size_t> max_points = {});

/// LS-DYNA keywords for *INCLUDE: a *DEFINE_CURVE_TITLE for each curve, in lines of 80 columns.
std::string ls_dyna_text(const CurveFile& file);

/// Blocks of the Radioss starter, to be included: a /FUNCT for each curve.
std::string radioss_text(const CurveFile& file);

/// For a file of one curve: comments that begin with "# ", a header such as "time_ms,force_kN", and the
/// pairs. Numbers read back as the same double.
std::string curve_csv(const CurveFile& file);

/// The bytes of a zip with a test in ISO-MME. All curves must be over time and exist; they are sampled every
/// iso_mme_interval from first contact on, linearly between the points of the history. Accelerations are in
/// m/s2 or in g, the rest in SI.
std::string iso_mme_zip(const CurveFile& file);
inline constexpr double iso_mme_interval = 1e-5;  ///< s: 100 kHz

/// Whether iso_mme_zip() takes a curve of that name.
bool is_over_time(const std::string& curve_name);

// All four throw std::invalid_argument for curves with x not strictly increasing, numbers that are not
// finite, and curve numbers outside of 1 to highest_curve_id; curve_csv() unless there is exactly one curve.

}  // namespace dashpad::output
