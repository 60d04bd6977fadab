#include "dashpad/impact/flags.hpp"

#include <cmath>

#include <fmt/format.h>

namespace dashpad {

namespace {

std::string missed_tolerance(const Summary& summary) {
  const std::string asked =
      std::isfinite(summary.tolerance) ? fmt::format("{:.2g} %", 100 * summary.tolerance) : "unknown";
  return fmt::format("TOLERANCE NOT MET: asked for {}; the errors may be larger than estimated", asked);
}

/// On a rigid support there is no force then, also where the tolerance was missed on the way there.
std::string bottoming(const Summary& summary) {
  return fmt::format("BOTTOMED at {:.5g} ms: the pad was fully compressed {}", 1e3 * summary.bottomed->time,
                     summary.peak_force
                         ? "for a while, in which only the support gave way"
                         : "on its rigid support, so that the force has no finite value there");
}

}  // namespace

std::vector<Flag> flags(const Summary& summary) {
  std::vector<Flag> all;
  if (summary.status == Status::not_run)
    all.push_back({"NOT RUN", "NOT RUN: nothing was computed"});
  else if (!summary.trustworthy())
    all.push_back({"TOLERANCE NOT MET", missed_tolerance(summary)});
  if (summary.status == Status::time_limit)
    all.push_back({"TIME LIMIT", "TIME LIMIT: the impactor was still on the pad when the time was up"});
  if (summary.bottomed) all.push_back({"BOTTOMED", bottoming(summary)});
  for (const std::string& reason : summary.extrapolations)
    all.push_back({"EXTRAPOLATED", "EXTRAPOLATED: " + reason});
  if (summary.extrapolated && summary.extrapolations.empty())
    all.push_back({"EXTRAPOLATED", "EXTRAPOLATED: outside the range in which the material was fitted"});
  return all;
}

}  // namespace dashpad
