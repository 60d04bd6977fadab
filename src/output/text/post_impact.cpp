#include "dashpad/output/post_impact.hpp"

#include <cmath>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/text/case.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string share(const char* what, double energy, double impact, const UnitSystem& units) {
  return fmt::format("    {:<30}{:>14}  {:>8.2f} %\n", what, brief_quantity(energy, "J", units),
                     100 * energy / impact);
}

}  // namespace

std::string post_impact_text(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution, const UnitSystem& units) {
  const PostImpact after = post_impact(first, second, solution);
  const EnergySplit split = energy_split(impact, solution);
  const auto shown = [&](double value, const char* si_unit) { return brief_quantity(value, si_unit, units); };
  const std::string other = std::isinf(second.mass) ? "held in place" : shown(second.mass, "kg");
  std::string text = fmt::format(
      "Two bodies: the impactor, {} at {}; the other, {}, at {}.\nSolved as one body of {} at {}, which is "
      "their motion towards each other.\n\n",
      shown(first.mass, "kg"), shown(first.velocity, "m/s"), other, shown(second.velocity, "m/s"),
      shown(impact.impactor.mass, "kg"), shown(impact.impactor.speed, "m/s"));
  for (const Flag& flag : flags(solution.summary)) text += one_line(flag.text) + "\n";
  const double error = solution.summary.errors.energy_absorbed;
  text += fmt::format("  Velocity of the impactor after   {} ± {}\n", shown(after.first_velocity, "m/s"),
                      shown(after.errors.first_velocity, "m/s"));
  text += fmt::format("  Velocity of the other after      {} ± {}\n", shown(after.second_velocity, "m/s"),
                      shown(after.errors.second_velocity, "m/s"));
  text += fmt::format("  Ratio of the speeds, sqrt(C)     {} ± {:.2g}\n", significant(after.restitution),
                      after.errors.restitution);
  text += fmt::format("  C of the report's Eqs. 1 to 3    {} ± {} of the energy\n",
                      significant(after.energy_coefficient), percentage(error));
  text +=
      "  The report calls C the coefficient of restitution, but it multiplies energy: the ratio of the\n"
      "  speeds of separation and approach is its square root.\n\n";
  text += fmt::format("  Energy available                 {}\n", shown(after.available_energy, "J"));
  text += "  When the force is largest:\n";
  text += share("motion", split.kinetic_at_peak, split.impact, units);
  text += share("stored in the support", split.support_at_peak, split.impact, units);
  text += share("put into the pad", split.pad_at_peak, split.impact, units);
  text += "  At the end:\n";
  text += share("rebound", split.rebound, split.impact, units);
  text += share("left in the support", split.support_at_end, split.impact, units);
  text += share("absorbed by the pad", split.pad, split.impact, units);
  return text;
}

}  // namespace dashpad::output
