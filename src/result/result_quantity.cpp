#include "dashpad/result/result_quantity.hpp"

#include <stdexcept>
#include <unordered_map>

namespace dashpad {

namespace {

const char* const by_coarser_run = "by the run with twice the step";

/// The role of a figure that is a response of studies.
ResultRole response(ResultRole role) {
  role.in_studies = true;
  return role;
}
/// The role of a response that people ask for first.
ResultRole main_response(ResultRole role) {
  role.is_main = true;
  return response(role);
}

/// The role of a response that is a figure of the pulse and grows with the force.
ResultRole measure(Doubt doubt, bool is_main = true) {
  ResultRole role{.growth = Growth::with_force, .doubt = doubt, .estimate = by_coarser_run};
  return is_main ? main_response(role) : response(role);
}

}  // namespace

const std::vector<ResultQuantity>& result_quantities() {
  // key, title, symbol, SI unit, meaning, source, part, role
  static const std::vector<ResultQuantity> all{
      // --- The impact ---
      {"peak_force", "Peak force", "F_max", "N", "largest force on the impactor", "Eq. 6", Part::impact,
       main_response({.row = 1,
                      .growth = Growth::with_force,
                      .doubt = Doubt::of_acceleration,
                      .estimate = "relative to it",
                      .absent = "where the pad bottoms out on a rigid support"})},
      {"peak_acceleration", "Peak acceleration", "a_max", "m/s2",
       "largest magnitude of the acceleration: for an impact, peak force divided by mass", "Eq. 1",
       Part::impact,
       main_response({.row = 2,
                      .growth = Growth::with_force,
                      .doubt = Doubt::of_acceleration,
                      .estimate = "that of the peak force",
                      .absent = "where the pad bottoms out on a rigid support"})},
      {"time_to_peak_force", "Time to peak force", "t_F", "s",
       "time of the largest force, from first contact", "Eq. 31", Part::impact,
       response({.row = 3,
                 .estimate = "relative to the time at which contact ends",
                 .absent = "where the pad bottoms out on a rigid support"})},
      {"peak_motion", "Peak displacement", "X_max", "m",
       "largest displacement of the impactor since first contact: pad and support together", "Eq. 1",
       Part::impact, main_response({.row = 6, .growth = Growth::with_motion, .estimate = "relative to it"})},
      {"peak_penetration", "Peak penetration", "Y_max", "m", "largest penetration into the pad, on the axis",
       "Eq. 4", Part::impact,
       main_response({.row = 4,
                      .growth = Growth::with_motion,
                      .doubt = Doubt::of_penetration,
                      .estimate = "relative to it"})},
      {"peak_strain", "Peak strain", "eps_max", "1", "largest strain of the pad, on the axis", "Eq. 5",
       Part::impact,
       response({.row = 14,
                 .growth = Growth::with_motion,
                 .doubt = Doubt::of_penetration,
                 .estimate = "that of the peak penetration"})},
      {"peak_strain_rate", "Peak strain rate", "", "1/s", "largest magnitude of the strain rate, on the axis",
       "Eq. 5", Part::impact, response({.row = 15, .growth = Growth::with_motion})},
      {"rebound_speed", "Rebound speed", "V_out", "m/s",
       "speed of the impactor at release, when no column is left under pressure", "Eq. 27", Part::impact,
       main_response({.row = 9,
                      .needs = Needs::release,
                      .doubt = Doubt::of_rebound,
                      .estimate = "relative to it, or to 0.001 of the impact speed if that is more",
                      .absent = "without release"})},
      {"restitution", "Restitution", "e", "1", "rebound speed divided by impact speed", "", Part::impact,
       response({.needs = Needs::release,
                 .doubt = Doubt::of_rebound,
                 .estimate = "that of the rebound speed",
                 .absent = "without release"})},
      {"contact_end", "End of contact", "t_c", "s",
       "the force falls below 0.1 % of its peak for the last time", "Eq. 28", Part::moment,
       main_response(
           {.row = 11,
            .needs = Needs::release,
            .estimate = "the larger of the errors of time and velocity",
            .absent =
                "where contact is not lost: at the time limit, after bottoming out, with a rigid foam that "
                "stops the impactor on a rigid support"})},
      {"release", "Release", "", "s", "no column of the pad is left under pressure", "Eq. 27", Part::moment,
       response({.needs = Needs::release, .absent = "if that does not occur"})},
      {"force_below_weight", "Force below weight", "", "s",
       "the force first falls below the impactor's weight on rebound: the end of the impact in the 1986 "
       "report",
       "", Part::moment,
       ResultRole{.row = 16,
                  .estimate = "the larger of the errors of time and velocity",
                  .absent = "if it does not"}},
      {"bottomed", "Bottomed", "", "s", "the pad is fully compressed on the axis for the first time",
       "Eq. 29", Part::moment,
       ResultRole{.estimate = "the larger of the errors of time and velocity", .absent = "if it never is"}},
      {"rest", "At rest", "", "s", "the impactor, under its weight, has come to rest on the pad",
       "section 4, Rest", Part::moment, ResultRole{.row = 12, .absent = "if it does not"}},
      {"peak_transmitted_force", "Peak force behind the support", "T_max", "N",
       "largest force of the support on the ground or the body behind it", "Eq. 41", Part::impact,
       main_response(
           {.row = 5,
            .growth = Growth::with_force,
            .needs = Needs::support,
            .estimate = "the largest of the errors of the support's four figures, relative to it",
            .absent =
                "for an elastic support on the ground, whose force is that of the pad, and where the pad "
                "bottoms out on a rigid one"})},
      {"peak_support_deflection", "Peak deflection", "", "m", "largest deflection of the support", "Eq. 41",
       Part::impact,
       response({.row = 7,
                 .growth = Growth::with_motion,
                 .needs = Needs::support,
                 .estimate = "that of the peak force behind the support",
                 .absent = "for an elastic support on the ground"})},
      {"support_set", "Permanent set of the support", "", "m",
       "permanent deflection of a support that crushes", "Eq. 43", Part::impact,
       main_response({.row = 8,
                      .growth = Growth::with_motion,
                      .needs = Needs::support,
                      .estimate = "the same, relative to the peak deflection",
                      .absent = "for supports that do not crush"})},
      {"body_speed", "Speed of the body", "", "m/s",
       "speed of the free body behind the support at the end, positive in the direction of the impact",
       "Eq. 42", Part::impact,
       main_response({.row = 10,
                      .needs = Needs::support,
                      .estimate = "the same, relative to the impact speed",
                      .absent = "without one"})},
      {"energy_absorbed_fraction", "Energy absorbed by the pad", "", "1",
       "fraction of the impact energy that neither the impactor nor the support and its moving parts have at "
       "the end; negative if the pad returns more energy than it received",
       "Eq. 30", Part::impact,
       main_response({.row = 13, .is_signed = true, .estimate = "relative to the impact energy"})},
      {"energy_residual_fraction", "Energy residual", "", "1",
       "fraction of the impact energy that the numerical solution does not account for, of either sign",
       "Eq. 30", Part::impact},
      // --- The pulse ---
      {"hic15", "HIC15", "HIC15", "1", "head injury criterion, windows of at most 15 ms, in g^2.5 s",
       "injury.md, HIC", Part::pulse, measure(Doubt::of_hic)},
      {"hic36", "HIC36", "HIC36", "1", "head injury criterion, windows of at most 36 ms, in g^2.5 s",
       "injury.md, HIC", Part::pulse, measure(Doubt::of_hic)},
      {"hic_unlimited", "Unlimited HIC", "HIC", "1",
       "head injury criterion, windows of any length, in g^2.5 s", "injury.md, HIC", Part::pulse,
       measure(Doubt::of_hic)},
      {"hic_d", "HIC(d)", "HIC(d)", "1", "0.75446 HIC36 + 166.4, for the free-motion headform",
       "injury.md, HIC", Part::pulse, measure(Doubt::of_hic_d, false)},
      {"clip_3ms", "3 ms clip", "a_3ms", "m/s2",
       "highest magnitude of the acceleration that is held for 3 ms without interruption", "injury.md, Clips",
       Part::pulse, measure(Doubt::of_acceleration)},
      {"cumulative_3ms", "Cumulative 3 ms clip", "", "m/s2",
       "highest magnitude of the acceleration that is held for 3 ms in total, in one or more intervals",
       "injury.md, Clips", Part::pulse, measure(Doubt::of_acceleration)},
      {"severity_index", "Severity index", "SI", "1", "Gadd's severity index, in g^2.5 s",
       "injury.md, Severity index and velocity change", Part::pulse, measure(Doubt::of_hic, false)},
      {"velocity_change", "Velocity change", "dV", "m/s",
       "magnitude of the integral of the acceleration over the pulse",
       "injury.md, Severity index and velocity change", Part::pulse,
       main_response({.estimate = by_coarser_run})},
      {"dwell_time", "Dwell time", "", "s",
       "total time for which the magnitude of the acceleration is above a level", "injury.md, Dwell",
       Part::pulse, ResultRole{.doubt = Doubt::of_level, .estimate = by_coarser_run}},
      {"time_to_peak", "Time to peak", "", "s",
       "time from the point at which the acceleration first reaches 5 % of its peak to the peak; for pulses "
       "that are not aligned, the time of the peak",
       "injury.md, Two pulses", Part::pulse, ResultRole{.estimate = by_coarser_run}},
      {"half_peak_width", "Width at half the peak", "", "s",
       "total time for which the magnitude of the acceleration is above half its peak",
       "injury.md, Two pulses", Part::pulse, ResultRole{.estimate = by_coarser_run}},
      // --- Energies, at the end of the run or over time ---
      {"impact_energy", "Impact energy", "", "J", "kinetic energy of the impactor at first contact", "Eq. 30",
       Part::energy},
      {"weight_work", "Work done by gravity", "", "J", "work done by the weight of the impactor", "Eq. 30",
       Part::energy},
      {"kinetic_energy", "Kinetic energy", "", "J", "kinetic energy of the impactor", "Eq. 30", Part::energy},
      {"support_energy", "Energy in the support", "", "J", "energy stored in the support", "Eq. 30",
       Part::energy},
      {"support_loss", "Lost in the support", "", "J", "energy lost by crushing and damping", "Eq. 30",
       Part::energy},
      {"moving_energy", "Moving support", "", "J",
       "kinetic energy of the panel and of the body behind the support", "Eq. 30", Part::energy},
      {"pad_energy", "Work on the pad", "", "J", "energy stored and lost in the pad", "Eq. 30", Part::energy},
      {"sheet_energy", "Energy of the sheet", "", "J",
       "energy given to a sheet on the pad: lost in the collision with the nose, or carried away by the "
       "sheet",
       "Eq. 56", Part::energy},
      {"residual_energy", "Residual energy", "", "J",
       "energy that the numerical solution does not account for, of either sign: impact energy and work "
       "done by gravity less all others",
       "Eq. 30", Part::energy},
      {"total_energy", "Sum of energies", "", "J",
       "sum over impactor, support and pad, less the work done by gravity", "Eq. 30", Part::energy},
      // --- The history ---
      {"time", "Time", "t", "s", "time from first contact, or as measured", "", Part::history},
      {"force", "Force", "F", "N", "force on the impactor, positive in compression", "Eq. 6", Part::history},
      {"pad_force", "Force of the pad", "", "N",
       "force of the foam below a sheet with mass; the sheet takes part of the force on the impactor",
       "Eq. 56", Part::history},
      {"acceleration", "Acceleration", "dV/dt", "m/s2",
       "acceleration of the impactor, positive towards the pad: negative while the pad pushes", "Eq. 1",
       Part::history},
      {"deceleration", "Deceleration", "-dV/dt", "m/s2",
       "acceleration of the impactor, positive away from the pad: positive while the pad pushes", "Eq. 1",
       Part::history},
      {"velocity", "Velocity", "V", "m/s",
       "velocity of the impactor, positive towards the pad: negative on rebound", "Eq. 1", Part::history},
      {"motion", "Displacement", "X", "m",
       "displacement of the impactor since first contact, positive towards the pad", "Eq. 1", Part::history},
      {"penetration", "Penetration", "Y", "m", "penetration into the pad, on the axis", "Eq. 4",
       Part::history},
      {"support_deflection", "Deflection of the support", "X_s", "m",
       "displacement of the impactor minus the penetration and the displacement of a body behind the support",
       "Eq. 4", Part::history},
      {"transmitted_force", "Force behind the support", "T", "N",
       "force of the support on the ground or the body behind it", "Eq. 41", Part::history},
      {"body_motion", "Displacement of the body", "", "m", "displacement of the free body behind the support",
       "Eq. 42", Part::history},
      {"contact_radius", "Contact radius", "r", "m", "radius of the outer edge of the stressed area", "Eq. 6",
       Part::history},
      {"axis_strain", "Strain on the axis", "eps", "1", "strain of the pad, positive in compression", "Eq. 5",
       Part::history},
  };
  return all;
}

const ResultQuantity* find_result_quantity(std::string_view key) {
  static const std::unordered_map<std::string_view, const ResultQuantity*> by_key = [] {
    std::unordered_map<std::string_view, const ResultQuantity*> all;
    for (const ResultQuantity& result_quantity : result_quantities())
      all.emplace(result_quantity.key, &result_quantity);
    return all;
  }();
  const auto found = by_key.find(key);
  return found == by_key.end() ? nullptr : found->second;
}

const ResultQuantity& result_quantity(std::string_view key) {
  const ResultQuantity* found = find_result_quantity(key);
  if (found == nullptr) throw std::invalid_argument("no quantity of a result: " + std::string{key});
  return *found;
}

std::string title_in_sentence(const ResultQuantity& result_quantity) {
  std::string title = result_quantity.title;
  const auto is_capital = [&](std::size_t i) { return title[i] >= 'A' && title[i] <= 'Z'; };
  if (title.size() > 1 && is_capital(0) && !is_capital(1)) title[0] = static_cast<char>(title[0] - 'A' + 'a');
  return title;
}

std::string key_with_unit(const ResultQuantity& result_quantity, const UnitSystem& units) {
  return name_with_unit(result_quantity.key, scaled_unit(result_quantity.si_unit, units).unit);
}

}  // namespace dashpad
