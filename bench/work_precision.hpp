#pragma once
/// Work against precision: what is compared, and at equal error how the times compare.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dashpad::bench {

/// The three figures by which a solution is judged, SI.
struct Outcome {
  double peak_force = 0;
  double peak_penetration = 0;
  double rebound_speed = 0;
};

/// Largest relative deviation of the three.
double deviation(const Outcome& outcome, const Outcome& reference);

/// A solver with its settings.
struct Contender {
  std::string solver;  ///< "dashpad", "march" (without the search for the resolution), "cvode"
  std::string setting;
  /// Solves the impact at a share of its speed; absent if the solver gives up.
  std::function<std::optional<Outcome>(double speed_share)> solve;
};

struct Measurement {
  std::string solver;
  std::string setting;
  double error = 0;           ///< largest over the speeds
  int failures = 0;           ///< speeds at which the solver gave up
  std::vector<double> times;  ///< s of CPU time, one a repetition
  bool on_front = false;      ///< no other setting of its solver is both faster and more accurate
  [[nodiscard]] double median() const { return quantile(0.5); }
  [[nodiscard]] double quantile(double share) const;
};

/// CPU time of one solution at full speed, s; short ones are repeated for about a millisecond.
double time_of(const Contender& contender);

/// Marks the front of each solver.
void mark_fronts(std::vector<Measurement>& measurements);

/// Time that the solver's front needs for an error, s.
struct FrontTime {
  double time = 0;
  /// '=': interpolated; '>': the front does not reach the error, the time is that of its most accurate point;
  /// '<': all of the front is more accurate, the time is that of its fastest point.
  char relation = '=';
};
FrontTime time_on_front(const std::vector<Measurement>& measurements, const std::string& solver,
                        double error);

}  // namespace dashpad::bench
