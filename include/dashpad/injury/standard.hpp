#pragma once
/// Test standards as plain values, and what a solved impact says about their limits.
///
/// An assessment is a computation with one rigid nose on a flat pad. It is no certification, and no test.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

/// What a source is beside the text of the law or standard that binds.
enum class SourceKind {
  own_text,   ///< that text itself, wherever it is printed
  secondary,  ///< a text that repeats or describes it
  none,       ///< no text: general knowledge, or a choice
};
/// "own text", "secondary", "no source": as files name them.
std::string to_string(SourceKind kind);

/// Where a value comes from, and whether it was read there.
struct Origin {
  std::string source;
  SourceKind kind = SourceKind::none;
  bool verified = false;
  std::string note;  ///< for people; often empty
};

/// A mass, radius or impact speed of a standard.
struct StandardValue {
  std::optional<double> value;        ///< kg, m or m/s; absent where the standard leaves it to the case
  std::optional<double> drop_height;  ///< m; of a speed that is given so
  Origin origin;
  bool chosen_by_user = false;    ///< the value is the user's, not the standard's
  std::optional<double> instead;  ///< the standard's own value, if another one of the user took its place
};

enum class Metric {
  peak_acceleration,
  clip_3ms,
  cumulative_3ms,
  dwell_time,  ///< cumulative, above a level
  hic15,
  hic36,
  hic_unlimited,
  hic_d,
  severity_index,
};

/// All of them, in the order of the enumeration.
const std::vector<Metric>& metrics();
/// What a metric limits: its key is that of files; the unit is "m/s2", "s" or "1".
const ResultQuantity& quantity_of(Metric metric);

/// A limit: the value of the metric must be at most this, or below it.
struct Criterion {
  Metric metric = Metric::peak_acceleration;
  double level = 0;     ///< m/s2; of dwell_time only
  double limit = 0;     ///< in the unit of the metric
  bool strict = false;  ///< the value must be below the limit
  std::string description;
  Origin origin;
};
/// What a criterion limits, for people; of a dwell time with the level: "Dwell time above 150 g".
std::string title_of(const Criterion& criterion);
/// "limit of peak acceleration".
std::string limit_of(const Criterion& criterion);

/// Values that take the place of those of the standard: another anvil, another size of headform.
struct StandardVariant {
  std::string name;
  std::string title;
  std::optional<StandardValue> mass, radius, speed;
};

struct Standard {
  std::string name;  ///< as on the command line
  std::string title;
  std::string article;  ///< the text that binds; may be empty
  std::string source;   ///< what was read
  SourceKind source_kind = SourceKind::none;
  std::string note;
  StandardValue mass, radius, speed;
  std::vector<Criterion> criteria;
  std::vector<StandardVariant> variants;  ///< to choose from
  std::vector<std::string> chosen;        ///< the variants that are in force
};

/// The standard with these variants in force. Throws std::invalid_argument that says what is wrong: no such
/// variant, or two that replace the same value.
Standard with_variants(const Standard& standard, const std::vector<std::string>& names);

/// What the user puts in the place of the standard's values.
struct UserValues {
  std::optional<double> mass;         ///< kg
  std::optional<double> radius;       ///< m
  std::optional<double> speed;        ///< m/s; give this or the drop height
  std::optional<double> drop_height;  ///< m
};
/// A value that is the standard's own replaces nothing.
Standard with_user_values(const Standard& standard, const UserValues& values);

/// Whether two values differ by more than the rounding of their units.
bool differ(double one, double other);

/// Speed after a free fall in vacuum, m/s.
double speed_after_fall(double height);

/// The case with the impactor of the standard; what the standard leaves open stays.
ImpactCase with_impactor_of(const Standard& standard, const ImpactCase& impact);

enum class Verdict { pass, fail, undecided };
/// "pass", "fail", "undecided".
std::string to_string(Verdict verdict);

struct CriterionResult {
  Criterion criterion;
  std::optional<double> value;  ///< absent where there is no finite one
  double error = 0;             ///< of the solver, estimated, absolute, in the unit of the value
  /// By what is not known of foam and model; absent where it was not asked for.
  std::optional<FigureInterval> interval;
  bool lower_bound = false;  ///< the pulse was cut: the value can only grow
  /// limit - value, at most that for a lower bound. Absent without a value, and where a lower bound is not
  /// above the limit: what is left of it then is no margin.
  std::optional<double> margin;
  std::optional<double> relative_margin;  ///< margin / limit
  Verdict verdict = Verdict::undecided;
  std::string reason;  ///< of a verdict that the numbers do not explain
};

/// Decides a result by its value, error, interval and whether it is a lower bound: fail where the value less
/// its error, or its interval, is above the limit as a whole; pass where it is within as a whole and no lower
/// bound; else undecided. With the margins.
void decide(CriterionResult& result);

/// One failure decides; one undecided criterion leaves a pass undecided.
Verdict verdict_of(const std::vector<CriterionResult>& results);

/// A figure of the impact, SI. Absent where it does not exist.
struct Figure {
  std::optional<double> value;
  bool lower_bound = false;  ///< the pulse was cut: the value can only grow
};

/// What is said beside every verdict, whatever the standard asks for.
struct KeyFigures {
  Figure peak_acceleration;
  Figure hic15, hic36;
  Figure peak_strain;    ///< on the axis
  Figure contact_end;    ///< since first contact
  Figure rebound_speed;  ///< at release
  Figure restitution;
};

struct Assessment {
  std::vector<CriterionResult> results;
  KeyFigures figures;
  Verdict verdict = Verdict::undecided;
  /// Why the verdict is not to be taken as it stands: a flag of the impact, a material of which nobody knows
  /// whether it was extrapolated, a limit or value that was not read in the standard itself, a value of the
  /// standard that was replaced.
  std::vector<Flag> reservations;

  [[nodiscard]] bool unqualified() const { return reservations.empty(); }
};

/// "pass", "pass, with reservations", "fail", ...
std::string to_string(const Assessment& assessment);

/// What of the limits was not read in the standard itself, UNVERIFIED and SECONDARY SOURCE: a line each.
std::vector<Flag> reservations_about_limits(const Standard& standard);

/// The levels of the dwell times that a standard limits, m/s2: uncertainty::add_intervals() is to know them.
std::vector<double> dwell_levels(const Standard& standard);

/// Judges the solution of `impact`, the case with the impactor of the standard: decide() of each criterion,
/// by its interval where there is one. A pad that bottomed out on a rigid support fails whatever is asked
/// for. A pulse that was cut before contact was lost gives lower bounds; the peak alone is final once the
/// impactor came to rest.
///
/// Throws std::invalid_argument for a standard without criteria and a solution without a history.
Assessment assess(const Standard& standard, const ImpactCase& impact, const Solution& solution);

// Where a standard and a case have different noses or speeds, one of the two is assessed. What the other
// would have said.

/// What of the case stays although the standard has a value for it.
struct Kept {
  bool nose = false;
  bool speed = false;
};

/// The standard with the nose and the speed left to the case, where they are to be kept and differ from its
/// own.
Standard with_kept(const Standard& standard, const Impactor& of_case, Kept kept);

/// A verdict that another choice of nose, speed or both would have given.
struct OtherChoice {
  Kept other;  ///< what is chosen the other way
  Kept kept;   ///< what of the case is kept then
  Assessment assessment;
};

/// The choices that turn a verdict into a pass or a fail; both together only where neither does alone. What
/// the user has given by a number is no choice. `standard` is not yet with_kept(). `judged` solves the case
/// with that impactor and assesses it.
std::vector<OtherChoice> turning_choices(
    const Standard& standard, const ImpactCase& given, Kept kept, Verdict verdict,
    const std::function<Assessment(const Standard&, const ImpactCase&)>& judged);

}  // namespace dashpad::injury
