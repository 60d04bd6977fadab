#pragma once
/// Curves as text for other programs. The files say whence they come, in which units and with which signs.
///
/// Text from users cannot break a file: it is brought to printable ASCII (what is not becomes "?"), stands
/// only behind words of our own, and is folded or cut to the width of a line.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/output/deck/curves.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

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
                     const std::vector<std::string>& names, std::optional<std::size_t> most_points = {});

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
