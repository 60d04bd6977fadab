#include "dashpad/output/post_impact.hpp"

#include "json/json_values.hpp"

namespace dashpad::output {

std::string post_impact_json(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution) {
  const PostImpact after = post_impact(first, second, solution);
  const EnergySplit split = energy_split(impact, solution);
  const Summary& summary = solution.summary;
  const Json result{
      {"status", to_string(summary.status)},
      {"extrapolated", !summary.extrapolations.empty()},
      {"bottomed", summary.bottomed.has_value()},
      {"bodies",
       {{{"mass_kg", number(first.mass)},
         {"velocity_m_per_s", number(first.velocity)},
         {"velocity_after_m_per_s", number(after.first_velocity)},
         {"velocity_after_error_m_per_s", number(after.errors.first_velocity)}},
        {{"mass_kg", number(second.mass)},
         {"velocity_m_per_s", number(second.velocity)},
         {"velocity_after_m_per_s", number(after.second_velocity)},
         {"velocity_after_error_m_per_s", number(after.errors.second_velocity)}}}},
      {"energy_coefficient_C", number(after.energy_coefficient)},
      {"restitution_sqrt_C", number(after.restitution)},
      {"restitution_error", number(after.errors.restitution)},
      {"absorbed_fraction_error", number(summary.errors.energy_absorbed)},
      {"available_energy_J", number(after.available_energy)},
      {"at_peak_force",
       {{"kinetic_J", number(split.kinetic_at_peak)},
        {"support_J", number(split.support_at_peak)},
        {"pad_J", number(split.pad_at_peak)}}},
      {"at_the_end",
       {{"rebound_J", number(split.rebound)},
        {"support_J", number(split.support_at_end)},
        {"pad_J", number(split.pad)}}},
      {"solved_as",
       {{"mass_kg", number(impact.impactor.mass)}, {"speed_m_per_s", number(impact.impactor.speed)}}},
      {"program", program_json()}};
  return result_json_text(result);
}

}  // namespace dashpad::output
