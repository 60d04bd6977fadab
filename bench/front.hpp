#pragma once
/// What a solver can do at best: the settings that no other one beats in both time and error.

#include <vector>

namespace dashpad::bench {

struct WorkPoint {
  double error = 0;
  double time = 0;
};

/// Those that no other point beats, from the most accurate to the fastest.
std::vector<WorkPoint> front_of(const std::vector<WorkPoint>& points);

/// Time that a front needs for an error.
struct FrontTime {
  double time = 0;
  /// '=': interpolated between the logarithms; '>': the front does not reach the error, the time is that of
  /// its most accurate point; '<': all of the front is more accurate, the time is that of its fastest point.
  char relation = '=';
};
/// The front must not be empty.
FrontTime time_on(const std::vector<WorkPoint>& front, double error);

}  // namespace dashpad::bench
