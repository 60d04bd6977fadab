#pragma once
/// Curves of a solved impact, as other programs take them, and their texts. The files say whence they come,
/// in which units and with which signs.
///
/// Text from users cannot break a file: it is brought to printable ASCII (what is not becomes "?"), stands
/// only behind words of our own, and is folded or cut to the width of a line.

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

/// y over x; x is strictly increasing, and no two points are nearer than smallest_gap of the largest x.
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

/// Of the largest x. Nearer points could not be told apart in single precision, with which some decks are
/// solved; of those that are left out, none is further from one that is kept.
inline constexpr double smallest_gap = 1e-6;

/// Largest part of the largest penetration over which a sudden fall of the force is spread, so that the force
/// stays a function of the penetration.
inline constexpr double widest_fall = 1e-3;

/// force, acceleration, velocity, motion, penetration: over time. loading, unloading: force over penetration.
const std::vector<std::string>& curve_names();

/// The curve of that name. Throws std::invalid_argument for another name. Signs are those of History.
Curve curve(const std::string& name, const Solution& solution);

/// Force over penetration from first contact to the largest penetration. Where the pad is held or springs
/// back for a while, the points up to the next new largest penetration are left out: each penetration has
/// the force with which it was first reached. So a pad that is fully compressed on a yielding support ends
/// the curve; the force beyond that belongs to the support.
Curve loading_branch(const History& history);

/// Force over penetration from the largest penetration back to release, given over increasing penetration.
/// Each penetration has the force with which it was last passed; the force is 0 from no penetration to that
/// of release, and at the largest penetration that of the loading branch. Where the force falls while the
/// pad is held at the largest penetration, the fall is spread over the last widest_fall of it, or over half
/// the way to the point before where that is less. Does not exist unless the impactor was released.
Curve unloading_branch(const Solution& solution);

struct ThinnedCurve {
  Curve curve;
  double error = 0;  ///< largest distance in y from the curve before, both taken as linear between points
};

/// At most `most_points` (2 or more) points of the curve: its ends, and one by one the point that is furthest
/// off.
ThinnedCurve thinned(const Curve& curve, std::size_t max_points);

struct FileCurve {
  Curve curve;         ///< SI
  std::string remark;  ///< how it was thinned, or why it does not exist
};

struct CurveFile {
  std::string title;                ///< of the case
  std::vector<std::string> origin;  ///< what strikes what
  std::vector<std::string> flags;   ///< what a reader must know before relying on the curves
  std::vector<FileCurve>
      curves;  ///< numbered from first_id in this order; one that does not exist keeps its number
  UnitSystem units = consistent_systems().front();
  bool acceleration_in_g = false;
  int first_id = 1;
};

/// LS-DYNA asks for less in some places; 8 digits leave a blank in a field of 10.
inline constexpr int highest_curve_id = 99'999'999;

/// The flags of a result, a line each: as dashpad/impact/flags.hpp names them, with what they
/// mean for its curves.
std::vector<std::string> flags_of(const Summary& summary);

/// The curves of those names, thinned to `most_points` if that is given, with title, origin and flags. Throws
/// std::invalid_argument for a name that is not one of curve_names().
CurveFile curve_file(const ImpactCase& impact, const Solution& solution,
                     const std::vector<std::string>& names, std::optional<std::size_t> max_points = {});

/// LS-DYNA keywords, to be read with *INCLUDE: a *DEFINE_CURVE_TITLE for each curve. Lines of 80 columns.
std::string ls_dyna_text(const CurveFile& file);

/// Blocks of the Radioss starter, to be read with #include: a /FUNCT for each curve.
std::string radioss_text(const CurveFile& file);

/// Comments that begin with "# ", a header such as "time_ms,force_kN", and the pairs. Numbers read back as
/// the same double. For a file of one curve.
std::string curve_csv(const CurveFile& file);

/// The bytes of a zip with a test in ISO-MME: the curves over time, sampled every iso_mme_interval from first
/// contact to the last whole interval; linear between the points of the history. Accelerations are in m/s2,
/// or in g. The other units are SI. For a file whose curves are all over time and exist.
std::string iso_mme_zip(const CurveFile& file);
inline constexpr double iso_mme_interval = 1e-5;  ///< s: 100 kHz

/// Whether iso_mme_zip() takes a curve of that name: not the branches over penetration.
bool is_over_time(const std::string& curve_name);

// Each throws std::invalid_argument for curves whose x does not increase strictly or whose numbers are not
// finite, for numbers of curves beyond 1 to highest_curve_id, and the last for more or less than one curve.

}  // namespace dashpad::output
