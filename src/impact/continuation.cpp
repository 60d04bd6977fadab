#include "dashpad/impact/continuation.hpp"

#include <algorithm>

#include "dashpad/impact/solve.hpp"
#include "model/pad/foam/foam_curve.hpp"

namespace dashpad {

void explore_continuation(const ImpactCase& impact, const Options& options, Summary& summary) {
  const auto explore = [&]<class Law>(const Law& law) {
    if constexpr (SharesSlip<Law>) {
      if (summary.status == Status::not_run || summary.peak_strain <= last_strain_of(law.curves.base)) return;
      const auto peak_with = [&](double exponent) {
        ImpactCase other = impact;
        std::get<Law>(other.pad.material.law).continuation_exponent = exponent;
        return solve(other, options).summary.peak_acceleration;
      };
      summary.continuation = {law.gentlest_continuation, law.steepest_continuation,
                              peak_with(law.gentlest_continuation), peak_with(law.steepest_continuation)};
    }
  };
  std::visit(explore, impact.pad.material.law);
}

}  // namespace dashpad
