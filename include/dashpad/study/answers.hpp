#pragma once
/// The evaluation of a study: location, spread, probabilities with intervals, and which factors matter.
///
/// All intervals are for 95 %. They hold for independent draws; with Sobol or Latin hypercube sampling, which
/// spread the draws more evenly, they are too wide rather than too narrow.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

struct Estimate {
  double value = 0;
  double low = 0, high = 0;  ///< 95 % interval; NaN where there is none
};

/// The distribution of a response over the rows that have it. All values are NaN if no row has one.
///
/// Rows that bottomed out on a rigid support (see Records::struck_through) stand above all values of a
/// response that grows with the force: quantiles and the greatest value are infinite where they fall on such
/// a row, and there is no mean and no deviation.
struct Distribution {
  std::uint64_t rows = 0;            ///< number of finite values
  std::uint64_t struck_through = 0;  ///< number of infinite values
  std::uint64_t without =
      0;          ///< number of rows without a value: the impactor did not leave, or the row was not run
  Estimate mean;  ///< Student's interval
  double deviation = 0;  ///< standard deviation of the rows, with n - 1
  double least = 0, greatest = 0;
  struct Quantile {
    double probability = 0;
    Estimate value;
  };
  /// Quantiles at 1, 5, 25, 50, 75, 95 and 99 %: the least value that this share of the rows does not exceed,
  /// with the interval between two order statistics, infinite if there are too few rows for a bound.
  std::vector<Quantile> quantiles;
};

/// The quantile at one of the probabilities above. None if no row has a value.
std::optional<Estimate> quantile(const Distribution& distribution, double probability);

/// Bounds of a response of one row, SI: equal where it is known, infinite if the pad bottomed out on a rigid
/// support; up to infinity where the value is a lower bound; infinite on both sides where nothing is known.
struct Reading {
  double low = 0, high = 0;
};

/// The probability that a response exceeds a limit, with its Clopper-Pearson interval. `value` leaves out
/// undecided rows, which could lie on either side of the limit; the interval covers both.
struct Exceedance {
  double limit = 0;  ///< SI
  Estimate probability;
  std::uint64_t exceeding = 0;       ///< rows above the limit, struck_through among them
  std::uint64_t struck_through = 0;  ///< rows above every limit
  std::uint64_t rows = 0;            ///< decided
  std::uint64_t undecided = 0;
};

/// In `values`, NaN is a row without a value and infinity one that bottomed out on a rigid support. The rows
/// of a grid are not `drawn` and have no sampling intervals: the interval of an exceedance covers undecided
/// rows alone, and is absent without any.
Distribution distribution(std::span<const double> values, bool drawn = true);
Exceedance exceedance(std::span<const Reading> rows, double limit, bool drawn = true);

/// Sobol' indices of a response (Saltelli's design, Jansen's estimators): the share of its variance that a
/// factor explains alone (first order) and with all interactions (total). Intervals are value +- 1.96
/// standard errors of the bootstrap over draws.
struct Sensitivity {
  struct Index {
    std::string factor;
    Estimate first, total;
  };
  std::vector<Index> indices;
  std::uint64_t draws = 0;     ///< used: those with all their rows, and a value in each
  std::uint64_t left_out = 0;  ///< the others
};

/// The estimators themselves, on plain numbers: `a`, `b` and, for each factor, `mixed`.
///
///   S_i  = 1 - mean((b - mixed_i)^2) / (2 V)      Jansen 1999; Saltelli et al. 2010, Table 2 (c)
///   ST_i =     mean((a - mixed_i)^2) / (2 V)      the same, Table 2 (f)
///
/// with V the variance of a and b together. All as long as `a`, at least 2.
struct SaltelliSample {
  std::vector<double> a, b;
  std::vector<std::vector<double>> mixed;  ///< the first matrix with factor i of the second
};
std::vector<Sensitivity::Index> jansen_indices(const SaltelliSample& sample, std::uint64_t bootstrap_seed);

/// The rows of a store that are there, by column.
struct Records {
  std::vector<std::uint64_t> rows;             ///< their numbers, increasing
  std::vector<std::vector<double>> factors;    ///< in the order of Study::factors, SI
  std::vector<std::vector<double>> responses;  ///< in the order of Study::responses, SI; NaN for none
  std::vector<Status> statuses;
  std::uint64_t doubtful = 0;        ///< is_doubtful()
  std::uint64_t extrapolated = 0;    ///< rows beyond what the material was measured for
  std::uint64_t beyond_strain = 0;   ///< rows beyond the tested strain; stores of 0.1.0 do not tell
  std::uint64_t beyond_rate = 0;     ///< and by their rate, a law
  std::uint64_t bottomed = 0;        ///< the pad was fully compressed at some time
  std::uint64_t struck_through = 0;  ///< rows that bottomed out on a rigid support, where no force is finite
  std::uint64_t time_limit = 0;      ///< the impactor was still on the pad when the time limit was reached
};
Records read_records(const Study& study, const Store& store);

/// The rows of one combination of levels, each a draw; with `indices` only those of the two matrices. A study
/// without sampled factors is a single group.
struct Group {
  std::vector<double> levels;       ///< levels of the factors that are not sampled, in their order; SI
  std::vector<std::size_t> places;  ///< indices in Records
  bool drawn = true;
};
std::vector<Group> groups(const Study& study, const Design& design, const Records& records);

/// The values of a response in a group: NaN for none, infinite for rows that bottomed out on a rigid support
/// if the response grows with the force.
std::vector<double> values_of(const Study& study, const Records& records, const Group& group,
                              std::size_t response);

/// The reliable bounds of the same values: none for a row that is doubtful or has no value, and a lower bound
/// at the time limit if the response grows during the impact.
std::vector<Reading> readings_of(const Study& study, const Records& records, const Group& group,
                                 std::size_t response);

/// The indices of a response at one combination of levels, numbered like the groups. Absent without `indices`
/// or with fewer than two whole draws.
std::optional<Sensitivity> sensitivity(const Study& study, const Design& design, const Records& records,
                                       std::size_t combination, std::size_t response);

/// Whether a row missed the tolerance, made no valid case, or lacks a response that its status promises
/// (has_response()). `responses` are the names of its values.
bool is_doubtful(const Outcome& outcome, std::span<const std::string> responses);

/// Counts of rows with reservations.
struct RowCounts {
  std::uint64_t doubtful = 0;
  std::uint64_t struck_through = 0;  ///< as in Records::struck_through
};
RowCounts row_counts(const Store& store);

/// Cushion curves in the manner of ASTM D1596: peak deceleration over static stress, for drop heights and
/// thicknesses (docs/studies.md). Static stress is the weight over the projected contact area at the largest
/// penetration; drop height is v^2 / 2 g. Curves of a sphere and of a platen must not be mixed.
struct CushionCurve {
  double thickness = 0;                   ///< m
  std::vector<double> static_stress;      ///< Pa, in the order of the masses
  std::vector<double> peak_deceleration;  ///< m/s2; NaN where the impact has none
};

/// The index of the least peak of a curve. None if no peak is finite.
std::optional<std::size_t> min_peak(const CushionCurve& curve);

struct CushionCurves {
  struct Drop {
    double height = 0;  ///< m
    double speed = 0;   ///< m/s
    std::vector<CushionCurve> curves;
  };
  std::vector<Drop> drops;     ///< the highest last
  bool whole_cushion = false;  ///< the nose is flat and covers all of the pad, as in ASTM D1596
};

/// The cushion curves; absent unless the study is a grid of impactor.mass (or impactor.weight) and at most
/// speed and thickness besides, and keeps peak_acceleration and peak_penetration.
std::optional<CushionCurves> cushion_curves(const Study& study, const Records& records);

/// The probability of more than this is asked for.
struct StudyLimit {
  std::string response;
  double value = 0;  ///< SI
};

/// A combination of levels in the order of a response, compared with the first draw by draw.
struct Ranked {
  std::size_t group = 0;  ///< in StudyAnswers::groups
  double median = 0;      ///< SI; infinite where the pad bottoms out
  /// Mean of its value less that of the first, over the same draws, with Student's interval; NaN if one of
  /// them bottoms out. Unused for the first.
  Estimate difference = {};
  Exceedance higher = {};  ///< draws in which it is above the first
};

/// The probability with which all limits are to be kept at a turning level.
inline constexpr double turning_probability = 0.95;

/// Where, along the levels of a factor, the limits come to be kept in 95 % of the draws. Each draw turns at
/// its own level, found on a straight line between the two levels about it in the largest ratio of a response
/// to its limit; a draw that turns more than once counts where it is kept for good.
struct TurningLevel {
  std::size_t factor = 0;      ///< in Study::factors
  std::size_t example = 0;     ///< in StudyAnswers::groups: one with the levels of the other factors
  bool kept_above = true;      ///< whether the limits are kept at larger levels
  double first = 0, last = 0;  ///< the least and the greatest level, SI
  /// The quantile of the draws' levels, SI, between order statistics: at an end of the levels the limits are
  /// kept there already; infinite, beyond the end, if they are not kept at any level.
  Estimate level = {};
  std::uint64_t draws = 0;  ///< that have all their responses at all levels
};

struct StudyQuestions {
  std::vector<std::string> responses = {};  ///< names; empty: all that the study keeps
  std::vector<StudyLimit> limits = {};
  std::vector<Flag> reservations = {};  ///< about the limits
};

struct StudyAnswers {
  Study study;
  std::string program;     ///< program that computed the rows
  std::uint64_t rows = 0;  ///< number of rows of the whole study
  Records records;
  std::vector<std::size_t> responses;  ///< asked for: numbers in Study::responses
  std::vector<StudyLimit> limits;
  std::vector<Flag> reservations;

  /// The answers for one combination of levels.
  struct OfGroup {
    Group group;
    std::vector<Distribution> distributions;  ///< for each response asked for
    std::vector<Exceedance> exceedances;      ///< for each limit
    /// Rows that exceed one limit or more, of two or more limits: of the largest ratio to its limit, the
    /// limit
    /// 1. A row is undecided if no limit is surely exceeded and one is undecided.
    std::optional<Exceedance> any = {};
    std::vector<std::optional<Sensitivity>> sensitivities;  ///< for each response asked for
  };
  std::vector<OfGroup> groups;
  std::vector<std::vector<Ranked>> rankings;  ///< of each response asked for; empty with one combination
  std::vector<TurningLevel> turns;  ///< the least level first; empty without draws, limits or levels
  std::optional<CushionCurves> cushion_curves;
};

/// The turning levels along the factor with the most levels that are numbers, for each combination of the
/// others. Empty if there is no such factor, or if the limits are kept as often at both of its ends.
std::vector<TurningLevel> turning_levels(const StudyAnswers& answers, const Design& design);

/// The combinations of drawn rows by the median of a response (index in StudyAnswers::responses), the least
/// first, compared over the draws that both have. Empty for fewer than two.
std::vector<Ranked> ranking(const StudyAnswers& answers, const Design& design, std::size_t response);

/// Throws std::invalid_argument for names that the study does not keep.
StudyAnswers study_answers(const Store& store, const StudyQuestions& questions);

}  // namespace dashpad::study
