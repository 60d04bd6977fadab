#pragma once
/// Test standards, and the assessment of a solved impact by their limits.
///
/// An assessment is a computation with one rigid nose on a flat pad. It is no certification, and no test.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

/// The relation of a source to the text of the law or standard that is binding.
enum class SourceKind {
  own_text,   ///< that text itself, wherever it is printed
  secondary,  ///< a text that repeats or describes it
  none,       ///< no text: general knowledge, or a choice
};
/// "own text", "secondary", "no source", as in files.
std::string to_string(SourceKind kind);

/// The source of a value, and whether the value was verified there.
struct Origin {
  std::string source;
  SourceKind kind = SourceKind::none;
  bool verified = false;
  std::string note;  ///< for people; often empty
};

/// A mass, radius or impact speed of a standard.
struct StandardValue {
  std::optional<double> value;        ///< kg, m or m/s; absent if the standard leaves it to the case
  std::optional<double> drop_height;  ///< m, if a speed is given by it
  Origin origin;
  bool chosen_by_user = false;    ///< the value is the user's, not the standard's
  std::optional<double> instead;  ///< the standard's own value, if the user replaced it
};

/// The quantities that a criterion may limit: the responses of studies, and times above a level.
std::vector<const ResultQuantity*> limitable_quantities();

/// The upper limit of a quantity.
struct Criterion {
  const ResultQuantity* quantity = &result_quantity("peak_acceleration");
  double level = 0;     ///< m/s2; of a dwell time only
  double limit = 0;     ///< in the SI unit of the quantity
  bool strict = false;  ///< the value must be below the limit
  std::string description;
  Origin origin;

  [[nodiscard]] bool has_level() const { return quantity->role.doubt == Doubt::of_level; }
  [[nodiscard]] bool limits(std::string_view key) const { return key == quantity->key; }
};
/// "Peak acceleration", or "Dwell time above 150 g" with the level of a dwell time.
std::string title_of(const Criterion& criterion);
/// "limit on peak acceleration".
std::string limit_of(const Criterion& criterion);

/// Values that replace those of the standard, such as another anvil or size of headform.
struct StandardVariant {
  std::string name;
  std::string title;
  std::optional<StandardValue> mass, radius, speed;
};

/// How a standard counts several drops from one height on one place.
struct DropSeries {
  std::vector<int> counted;  ///< numbers of the drops whose mean counts, from 1, increasing
  double step = 0;  ///< m, by which heights increase, and to whose multiples a result is rounded down
  Origin origin;
};

struct Standard {
  std::string name;  ///< as on the command line
  std::string title;
  std::string article;  ///< the binding text; may be empty
  std::string source;   ///< the text that was read
  SourceKind source_kind = SourceKind::none;
  std::string note;
  StandardValue mass, radius, speed;
  std::vector<Criterion> criteria;
  std::optional<DropSeries> drop_series = {};  ///< absent if each drop counts by itself
  std::vector<StandardVariant> variants;       ///< available variants
  std::vector<std::string> chosen;             ///< variants in force
};

/// The standard with these variants in force. Throws std::invalid_argument for an unknown variant, or for two
/// that replace the same value.
Standard with_variants(const Standard& standard, const std::vector<std::string>& names);

/// Values of the user that replace those of the standard.
struct UserValues {
  std::optional<double> mass;         ///< kg
  std::optional<double> radius;       ///< m
  std::optional<double> speed;        ///< m/s; give this or the drop height
  std::optional<double> drop_height;  ///< m
};
/// Applies the values of the user. A value equal to the standard's replaces nothing.
Standard with_user_values(const Standard& standard, const UserValues& values);

/// The standard without its own value of `key`, "impactor.mass", "impactor.radius" or "impactor.speed", if it
/// has one: that of the case takes its place, as one that the user gave.
Standard without_value_of(const Standard& standard, const std::string& key);

/// Whether two values differ by more than the rounding of their units.
bool differ(double one, double other);

/// Speed after a free fall in vacuum, m/s.
double speed_after_fall(double height);

/// The case with the impactor of the standard, where the standard specifies it.
ImpactCase with_impactor_of(const Standard& standard, const ImpactCase& impact);

enum class Verdict { pass, fail, undecided };
/// "pass", "fail", "undecided".
std::string to_string(Verdict verdict);

struct CriterionResult {
  Criterion criterion;
  std::optional<double> value;  ///< absent if there is no finite one
  double error = 0;             ///< estimated absolute error of the solver, in the unit of the value
  /// Interval by the uncertainty of foam and model; absent unless requested.
  std::optional<FigureInterval> interval;
  bool lower_bound = false;  ///< the pulse was cut: the value can only grow
  /// limit - value; for a lower bound an upper bound of it. Absent without a value, and for a lower bound
  /// that is not above the limit.
  std::optional<double> margin;
  std::optional<double> relative_margin;  ///< margin / limit
  Verdict verdict = Verdict::undecided;
  std::string reason;  ///< of a verdict that the numbers do not explain
};

/// Decides a result and sets its margins. Fail: the value, or the whole interval, is above the limit by more
/// than the error. Pass: it is within the limit with the error added, and no lower bound. Else undecided.
void decide(CriterionResult& result);

/// Fail if one criterion fails; else undecided if one is undecided; else pass.
Verdict verdict_of(const std::vector<CriterionResult>& results);

/// A figure of the impact, SI; absent if it does not exist.
struct Figure {
  std::optional<double> value;
  bool lower_bound = false;  ///< the pulse was cut: the value can only grow
};

/// The figures shown beside every verdict.
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
  /// Reservations about the verdict: flags of the impact, a material without a known range, limits or values
  /// that were not verified in the standard itself, values of the standard that were replaced.
  std::vector<Flag> reservations;

  [[nodiscard]] bool unqualified() const { return reservations.empty(); }
};

/// "pass", "pass, with reservations", "fail", ...
std::string to_string(const Assessment& assessment);

/// UNVERIFIED and SECONDARY SOURCE: the limits that were not verified in the standard itself.
std::vector<Flag> reservations_about_limits(const Standard& standard);

/// The levels of the dwell times that a standard limits, m/s2, for uncertainty::add_intervals().
std::vector<double> dwell_levels(const Standard& standard);

/// Assesses the solution of `impact`, the case with the impactor of the standard, by decide() for each
/// criterion. A pad that bottomed out on a rigid support always fails. A pulse that was cut before contact
/// was lost gives lower bounds; only the peak is final once the impactor has come to rest.
///
/// Throws std::invalid_argument for a standard without criteria or a solution without a history.
///
/// Example:
/// \code
/// #include "dashpad/impact/solve.hpp"
/// #include "dashpad/input/standard_file.hpp"
/// const auto standard = dashpad::input::read_standard("standards/en-1078.toml").value();
/// const auto dropped = dashpad::injury::with_impactor_of(standard, impact);  // its headform and speed
/// const auto assessment = dashpad::injury::assess(standard, dropped, dashpad::solve(dropped));
/// std::puts(to_string(assessment).c_str());  // "pass, with reservations"
/// \endcode
Assessment assess(const Standard& standard, const ImpactCase& impact, const Solution& solution);

// If the noses or speeds of a standard and a case differ, one of the two is assessed; the following shows
// what the other would give.

/// Properties of the case that are kept although the standard specifies them.
struct Kept {
  bool nose = false;
  bool speed = false;
};

/// The standard without the nose or the speed that are to be kept, if they differ from those of the case.
Standard with_kept(const Standard& standard, const Impactor& of_case, Kept kept);

/// The verdict for another choice of nose, speed or both.
struct OtherChoice {
  Kept other;  ///< the changed choices
  Kept kept;   ///< what is kept of the case then
  Assessment assessment;
};

/// The choices that turn a verdict into a pass or a fail; both together only if neither does so alone. Values
/// that the user gave are no choices. `standard` is before with_kept(). `judged` solves and assesses.
std::vector<OtherChoice> turning_choices(
    const Standard& standard, const ImpactCase& given, Kept kept, Verdict verdict,
    const std::function<Assessment(const Standard&, const ImpactCase&)>& judged);

}  // namespace dashpad::injury
