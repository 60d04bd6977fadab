#pragma once
/// Detection of rest of an impactor pressed on the pad by its weight (theory.md, section 4, Rest).

#include <algorithm>
#include <cmath>
#include <optional>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/quantities/constants.hpp"
#include "impact/numerics.hpp"
#include "impact/trial.hpp"

namespace dashpad {

/// Follows the speed from one turn of the impactor to the next.
class Swing {
 public:
  /// If the impactor has come to rest, the distance that it would still sink with its speed decaying
  /// exponentially, m; else nothing. `before`: its velocity at the state before `now`, m/s, `step` s ago.
  std::optional<double> rest(double before, const State& now, double step, const Impactor& impactor) {
    const double slow = numerics.speed_at_rest * impactor.speed;
    const bool turns = (before > 0) != (now.velocity > 0);
    const bool has_swung = turns && turns_ > 0;
    const double swing = fastest_;
    fastest_ = turns ? std::abs(now.velocity) : std::max(fastest_, std::abs(now.velocity));
    if (turns) ++turns_;
    if (std::abs(now.back.velocity()) > slow || turns_ == 0) return std::nullopt;
    if (has_swung && swing < slow) {
      last_ = swing;
      return 0;
    }
    if (has_swung) slowest_ = slowest_ > 0 ? std::min(slowest_, swing) : swing;
    const double weight = impactor.mass * impactor.gravity;
    const bool creeps = std::abs(now.velocity) < numerics.creep_at_rest * impactor.speed &&
                        std::abs(now.force - weight) < numerics.creep_at_rest * weight;
    if (!creeps) return std::nullopt;
    const double slows = (before - now.velocity) / step;
    if (now.velocity <= 0) return 0;
    return slows > 0 ? now.velocity * now.velocity / slows : infinite;
  }

  /// Largest speed in the swing with which it came to rest, and in the slowest of all others, m/s; 0: none.
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] double slowest() const { return slowest_; }

 private:
  double fastest_ = 0;  ///< largest speed since the last turn, m/s
  double last_ = 0;
  double slowest_ = 0;
  int turns_ = 0;
};

}  // namespace dashpad
