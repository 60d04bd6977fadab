// The document of two bodies after an impact: their velocities and where the energy went.

#include "dashpad/output/impact.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "output/layout.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Table energies(const char* caption, const std::vector<std::pair<const char*, double>>& parts, double impact,
               const UnitSystem& units) {
  Table table{.caption = caption, .columns = {"", "Energy", "Share"}};
  for (const auto& [what, energy] : parts)
    table.rows.push_back(
        {what, brief_quantity(energy, "J", units), fmt::format("{:.2f} %", 100 * energy / impact)});
  return table;
}

/// A row whose error is in its own unit.
ValueRow row_of(const char* label, double value, double error, const char* si_unit, const UnitSystem& units) {
  return {.label = label,
          .value = brief_quantity(value, si_unit, units),
          .remark = fmt::format("± {}", brief_quantity(error, si_unit, units))};
}

}  // namespace

Document post_impact_document(const Body& first, const Body& second, const ImpactCase& impact,
                              const Solution& solution, const UnitSystem& units) {
  const PostImpact after = post_impact(first, second, solution);
  const EnergySplit split = energy_split(impact, solution);
  const auto shown = [&](double value, const char* si_unit) { return brief_quantity(value, si_unit, units); };
  const std::string other = std::isinf(second.mass) ? "held in place" : shown(second.mass, "kg");
  Document document{.title = "After the impact"};
  document.warnings = by_severity(flags(solution.summary));
  document.lead = Lead{
      .answer = std::isinf(second.mass)
                    ? fmt::format("Afterwards, the impactor moves at {}", shown(after.first_velocity, "m/s"))
                    : fmt::format("Afterwards, the impactor moves at {} and the other body at {}",
                                  shown(after.first_velocity, "m/s"), shown(after.second_velocity, "m/s")),
      .tone = document.warnings.empty() ? Tone::plain : Tone::doubtful,
      .subject = {fmt::format("Two bodies: the impactor, {}, at {}; the other body, {}, at {}.",
                              shown(first.mass, "kg"), shown(first.velocity, "m/s"), other,
                              shown(second.velocity, "m/s")),
                  fmt::format("Solved as a single body with the reduced mass, {}, at the closing speed, {}.",
                              shown(impact.impactor.mass, "kg"), shown(impact.impactor.speed, "m/s"))},
      .figures = {
          row_of("Final velocity of the impactor", after.first_velocity, after.errors.first_velocity, "m/s",
                 units),
          row_of("Final velocity of the other body", after.second_velocity, after.errors.second_velocity,
                 "m/s", units),
          {.label = "Ratio of speeds, sqrt(C)",
           .value = significant(after.restitution),
           .remark = fmt::format("± {:.2g}", after.errors.restitution)},
          {.label = "C in Eqs. 1 to 3 of the report",
           .value = significant(after.energy_coefficient),
           .remark = fmt::format("± {} of the energy", percentage(solution.summary.errors.energy_absorbed))},
          {.label = "Energy available", .value = shown(after.available_energy, "J")}}};
  document.sections = {
      {.seen = Seen::always,
       .paragraphs =
           {"The report calls C the coefficient of restitution, but C multiplies an energy; the ratio of the "
            "separation speed to the approach speed is its square root."}},
      {.heading = "Energy balance",
       .seen = Seen::always,
       .tables = {energies("At peak force",
                           {{"Kinetic energy", split.kinetic_at_peak},
                            {"Stored in the support", split.support_at_peak},
                            {"Work on the pad", split.pad_at_peak}},
                           split.impact, units),
                  energies("At the end",
                           {{"Rebound", split.rebound},
                            {"Remaining in the support", split.support_at_end},
                            {"Absorbed by the pad", split.pad}},
                           split.impact, units)}}};
  return document;
}

}  // namespace dashpad::output
