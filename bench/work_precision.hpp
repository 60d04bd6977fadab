#pragma once
/// Work against precision: what is compared, how it is judged and timed.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dashpad::bench {

/// The figures by which a solution is judged, SI. The rebound speed is that of the end of the impact as its
/// solver has it.
struct Outcome {
  double peak_force = 0;
  double peak_penetration = 0;
  double rebound_speed = 0;
};

/// The converged solution: it has both ends of an impact.
struct Reference {
  Outcome released;
  double speed_at_weight = 0;  ///< when the force falls below the weight: the end of the program of 1984
};

/// By share of the case's speed.
using References = std::map<double, Reference>;

inline constexpr std::array speed_shares{0.96, 0.98, 1.0, 1.02, 1.04};

/// Relative deviations.
struct Errors {
  double peak_force = 0;
  double peak_penetration = 0;
  double rebound_speed = 0;
  [[nodiscard]] double largest() const;
};
Errors deviation(const Outcome& outcome, const Outcome& reference);
/// The larger of each.
Errors worse(const Errors& a, const Errors& b);

/// A solver with its settings.
struct Contender {
  std::string solver;
  std::string setting;
  /// Solves the impact at a share of its speed; absent if the solver gives up.
  std::function<std::optional<Outcome>(double speed_share)> solve;
  bool ends_at_weight = false;  ///< its rebound speed is that at which the force falls below the weight
};

struct Measurement {
  std::string solver;
  std::string setting;
  Errors errors;              ///< largest of each over the speeds
  int failures = 0;           ///< speeds at which the solver gave up
  std::vector<double> times;  ///< s of CPU time, one a repetition
  [[nodiscard]] double median() const { return quantile(0.5); }
  [[nodiscard]] double quantile(double share) const;
};

/// Adds the errors at one speed; false if the solver gave up. A solver that gives up at full speed is out.
bool judge(const Contender& contender, double speed_share, const References& references, Measurement& into);

/// Whether another setting of the same solver is as accurate in `margin` times less time.
bool is_beaten(const Measurement& m, const std::vector<Measurement>& all, double margin);

/// CPU time of one solution at full speed, s; short ones are repeated for about a millisecond.
double time_of(const Contender& contender);

}  // namespace dashpad::bench
