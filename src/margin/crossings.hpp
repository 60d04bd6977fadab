#pragma once
/// Where the largest of several curves crosses zero within a range, at few places looked at.
///
/// The curves are excesses: asinh((figure - limit) / |limit|), at most zero where the limit is kept. They are
/// looked at over an even grid, then between neighbours of the same sign wherever their second differences
/// leave room for two crossings, then inside each change of sign until the place is known to `precision`.

#include <functional>
#include <vector>

namespace dashpad::margin {

/// The curves at a place of the range, from 0 to 1. NaN: no value; infinite: beyond all limits.
struct Look {
  double place = 0;
  std::vector<double> curves = {};

  /// The largest; NaN where one has no value and none of the others is above zero.
  [[nodiscard]] double worst() const;
};

/// A change of the sign of the worst curve.
struct Crossing {
  double before = 0, after = 0;  ///< places on either side, apart by `precision` at most
  double place = 0;              ///< between them, by a straight line; of a jump, the middle
  bool rises = false;            ///< the limits are kept before it, and not after it
  bool jumps = false;            ///< the curve leaps over zero: no place has the limit itself
};

/// A stretch without a value, by the places that have one on either side, or the ends of the range.
struct Gap {
  double from = 0, to = 1;
};

struct CrossingSearch {
  std::vector<Look> looks;  ///< by place
  std::vector<Crossing> crossings;
  std::vector<Gap> gaps;
  bool is_complete = true;  ///< false: max_looks were too few to exclude further crossings
};

struct SearchSettings {
  int grid = 24;             ///< steps of the first look over the range
  int max_looks = 120;       ///< in all, but for what a change of sign found late needs
  double precision = 3e-5;   ///< of the place of a crossing
  double shortest = 2.5e-4;  ///< stretches shorter than it are not divided for a pair of crossings
  double noise = 0;          ///< of the curves: what lies this near to zero cannot be told from it
  /// The room that second differences leave is taken so many times as large as that of a parabola: between
  /// two places a corner leaves the straight line four times as far as they tell, and a leap eight times. At
  /// 16 some 4 of 100,000 random questions miss a pair of crossings, at 8 some 10.
  double caution = 16;
};

/// The curves at a place.
using CurvesAt = std::function<std::vector<double>(double place)>;

/// Every crossing of the worst curve. `known` are places looked at before.
CrossingSearch find_crossings(const CurvesAt& curves_at, const SearchSettings& settings,
                              std::vector<Look> known = {});

}  // namespace dashpad::margin
