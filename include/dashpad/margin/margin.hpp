#pragma once
/// The values of one number of a case at which a verdict turns: the pad that passes, the height that hurts.
///
/// The margin of a limit is L - f for a figure f. What is followed over the range of the key is the excess
/// asinh((f - L) / |L|) of the limit that is exceeded by most, at most zero where all are kept. It bends (a
/// pad too soft bottoms out, one too hard is hard), so that all of its zeros are looked for, not the first.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "dashpad/study/answers.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::margin {

/// A limit on a figure.
struct Limit {
  const ResultQuantity* figure = nullptr;
  double level = 0;         ///< m/s2; of a dwell time only
  double value = 0;         ///< SI; not 0
  bool at_least = false;    ///< the figure must be at least that, not at most
  bool is_aim = false;      ///< "hic15 = 700": where the figure has that value is asked, not where it is kept
  std::string title = {};   ///< "HIC15", "Dwell time above 150 g"
  std::string origin = {};  ///< the standard; empty for a limit of the user
};

/// An impact whose figures have limits. One for each standard, whose impactor differs.
struct Judged {
  ImpactCase impact;
  std::optional<injury::Standard> standard = {};  ///< its criteria are limits
  std::vector<Limit> limits = {};                 ///< others
};

/// A share of draws in which all limits are to be kept.
struct Chance {
  double probability = 0.95;                          ///< 0.5 to 0.999
  std::vector<study::Factor> factors;                 ///< what is drawn
  std::vector<study::Correlation> correlations = {};  ///< by places in `factors`
  bool foam = false;                                  ///< also all that the cards leave uncertain
  std::uint64_t draws = 1024;
  std::uint64_t seed = 1;
};

struct Question {
  std::vector<Judged> impacts;
  std::string key;   ///< one of study::factor_keys(), with a unit
  std::string unit;  ///< its SI unit
  double low = 0, high = 0;
  bool logarithmic = false;  ///< the range is divided by equal ratios
  Options options = {};
  bool intervals = true;  ///< also where the uncertainty of the foam lets the verdict turn; not with a chance
  std::optional<Chance> chance = {};
};

/// The limits of all impacts, in order.
std::vector<Limit> limits_of(const Question& question);

/// Whether the question is where one figure has a value, not where limits are kept.
bool is_aim(const Question& question);

/// The rules that the question breaks, under the options of the command: "--between", "--vary KEY".
std::vector<Violation> violations(const Question& question);

/// Sets the range to a quarter and four times the value of the first impact, or as much of it as breaks no
/// rule, divided by equal ratios. False if the impact has no value of the key above 0.
bool choose_range(Question& question);

/// A place of the range and what is known there; without draws the figures of one impact, with them the
/// quantiles over the draws at the probability of the question.
struct Place {
  double value = 0;                     ///< of the key, SI
  std::vector<double> figures = {};     ///< of each limit; NaN for none, infinite if the pad bottomed out
  double excess = 0;                    ///< of the worst limit: at most 0 if all are kept; NaN if unknown
  std::size_t worst = 0;                ///< that limit
  double low = 0, high = 0;             ///< the excess at the ends of its interval; equal to it without one
  double share = 0;                     ///< of the draws that keep all limits; with a chance
  std::vector<Flag> reservations = {};  ///< about the impacts there
  bool is_doubtful = false;             ///< an impact, or a draw, missed the tolerance
  std::string why_unknown = {};         ///< the rule that the case breaks there, or why a figure is missing
};

/// A value at which the verdict turns.
struct Turn {
  double value = 0;           ///< of the key, SI
  double precision = 0;       ///< half the width of the bracket
  bool passes_above = false;  ///< the limits are kept above it, not below
  bool jumps = false;         ///< the figure leaps over its limit
  std::size_t limit = 0;      ///< the limit that decides
  /// The values between which it lies, by what is uncertain of foam and model or by the number of draws.
  /// Infinite where the range of the key does not hold the end; absent without intervals.
  std::optional<std::pair<double, double>> interval = {};
};

enum class Zone { pass, fail, undecided, unknown };
/// "pass", "fail", "undecided", "unknown".
const char* to_string(Zone zone);

/// A stretch of the range with one verdict: undecided where an interval holds the limit.
struct Stretch {
  double from = 0, to = 0;
  Zone zone = Zone::unknown;
};

/// How much of the scatter of the worst excess at the turn a factor explains by itself: the squared
/// correlation of ranks.
struct Contributor {
  std::string key;
  double share = 0;
};

struct Answer {
  Question question;
  std::vector<Limit> limits;
  std::vector<Place> places;                ///< looked at, by value
  std::vector<Turn> turns;                  ///< by value
  std::vector<Stretch> stretches;           ///< of the whole range, by the verdict
  std::vector<Stretch> kept;                ///< the same by the figures themselves, without their intervals
  std::optional<std::size_t> nearest = {};  ///< of places: the least excess; absent if all are unknown
  std::vector<Contributor> contributors = {};  ///< largest first; with a chance
  std::vector<Flag> reservations = {};  ///< about the impacts at the first turn, or at the nearest place
  std::size_t doubtful = 0;             ///< places at which the tolerance was missed
  bool is_complete = true;              ///< false: the search stopped before it could exclude further turns
  std::uint64_t impacts = 0;
  double seconds = 0;
};

/// Called now and then with the share of the work that is done; returns false to stop.
using Progress = std::function<bool(double share)>;

/// Answers a question without violations(). Throws std::runtime_error if progress says to stop.
///
/// Example:
/// \code
/// dashpad::margin::Question question{.impacts = {{.impact = impact}}, .key = "pad.thickness", .unit = "m"};
/// question.impacts.front().limits = {
///     {.figure = &dashpad::result_quantity("hic15"), .value = 700, .title = "HIC15"}};
/// if (dashpad::margin::choose_range(question) && dashpad::margin::violations(question).empty())
///   for (const dashpad::margin::Turn& turn : dashpad::margin::solve_for(question).turns)
///     std::printf("%s %.1f mm\n", turn.passes_above ? "from" : "up to", 1e3 * turn.value);
/// \endcode
Answer solve_for(const Question& question, const Progress& progress = {});

}  // namespace dashpad::margin
