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
                      .estimate = "relative to the figure",
                      .absent = "if the pad bottoms out on a rigid support"})},
      {"peak_acceleration", "Peak acceleration", "a_max", "m/s2",
       "largest magnitude of the acceleration; for an impact, the peak force divided by the mass", "Eq. 1",
       Part::impact,
       main_response({.row = 2,
                      .growth = Growth::with_force,
                      .doubt = Doubt::of_acceleration,
                      .estimate = "that of the peak force",
                      .absent = "if the pad bottoms out on a rigid support"})},
      {"time_to_peak_force", "Time to peak force", "t_F", "s", "time from first contact to the largest force",
       "Eq. 31", Part::impact,
       response({.row = 3,
                 .estimate = "relative to the time at which contact ends",
                 .absent = "if the pad bottoms out on a rigid support"})},
      {"peak_motion", "Peak displacement", "X_max", "m",
       "largest displacement of the impactor from first contact, taken up by pad and support together",
       "Eq. 1", Part::impact,
       main_response({.row = 6, .growth = Growth::with_motion, .estimate = "relative to the figure"})},
      {"peak_penetration", "Peak penetration", "Y_max", "m", "largest penetration into the pad, on the axis",
       "Eq. 4", Part::impact,
       main_response({.row = 4,
                      .growth = Growth::with_motion,
                      .doubt = Doubt::of_penetration,
                      .estimate = "relative to the figure"})},
      {"peak_strain", "Peak strain", "eps_max", "1", "largest strain of the pad, on the axis", "Eq. 5",
       Part::impact,
       response({.row = 14,
                 .growth = Growth::with_motion,
                 .doubt = Doubt::of_penetration,
                 .estimate = "that of the peak penetration"})},
      {"peak_strain_rate", "Peak strain rate", "", "1/s", "largest magnitude of the strain rate, on the axis",
       "Eq. 5", Part::impact, response({.row = 15, .growth = Growth::with_motion})},
      {"rebound_speed", "Rebound speed", "V_out", "m/s",
       "speed of the impactor at release, when no column is under pressure", "Eq. 27", Part::impact,
       main_response({.row = 9,
                      .needs = Needs::release,
                      .doubt = Doubt::of_rebound,
                      .estimate = "relative to the figure, or to 0.001 of the impact speed if that is larger",
                      .absent = "if there is no release"})},
      {"restitution", "Restitution", "e", "1", "rebound speed divided by impact speed", "", Part::impact,
       response({.needs = Needs::release,
                 .doubt = Doubt::of_rebound,
                 .estimate = "that of the rebound speed",
                 .absent = "if there is no release"})},
      {"rebound_height", "Rebound height", "", "m",
       "height to which the rebound speed would throw the impactor up in a vacuum", "", Part::impact,
       response({.needs = Needs::release,
                 .doubt = Doubt::of_rebound_height,
                 .estimate = "twice that of the rebound speed",
                 .absent = "if there is no release"})},
      {"contact_end", "End of contact", "t_c", "s",
       "moment at which the force falls below 0.1 % of its peak for the last time", "Eq. 28", Part::moment,
       main_response({.row = 11,
                      .needs = Needs::release,
                      .estimate = "the larger of the errors of time and velocity",
                      .absent = "if contact is not lost: the time limit was reached, the pad bottomed out, "
                                "or a rigid foam on a rigid support stopped the impactor"})},
      {"release", "Release", "", "s", "moment from which no column of the pad is under pressure", "Eq. 27",
       Part::moment, response({.needs = Needs::release, .absent = "if there is none"})},
      {"force_below_weight", "Force below weight", "", "s",
       "moment at which the force first falls below the impactor's weight on rebound: the end of the impact "
       "in the 1986 report",
       "", Part::moment,
       ResultRole{.row = 16,
                  .estimate = "the larger of the errors of time and velocity",
                  .absent = "if there is none"}},
      {"bottomed", "Bottomed", "", "s", "moment at which the pad is first fully compressed on the axis",
       "Eq. 29", Part::moment,
       ResultRole{.estimate = "the larger of the errors of time and velocity", .absent = "if there is none"}},
      {"rest", "At rest", "", "s",
       "moment at which the impactor comes to rest on the pad under its own weight", "section 4, Rest",
       Part::moment, ResultRole{.row = 12, .absent = "if there is none"}},
      {"peak_transmitted_force", "Peak force behind the support", "T_max", "N",
       "largest force exerted by the support on the ground or on the body behind it", "Eq. 41", Part::impact,
       main_response({.row = 5,
                      .growth = Growth::with_force,
                      .needs = Needs::support,
                      .estimate = "the largest error of the four support figures, relative to the figure",
                      .absent = "for an elastic support on the ground, which transmits the pad force "
                                "unchanged, and if the pad bottoms out on a rigid support"})},
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
                      .estimate = "that of peak_transmitted_force, relative to the peak deflection",
                      .absent = "for supports that do not crush"})},
      {"body_speed", "Speed of the body", "", "m/s",
       "speed of the free body behind the support at the end, positive in the direction of the impact",
       "Eq. 42", Part::impact,
       main_response({.row = 10,
                      .needs = Needs::support,
                      .estimate = "that of peak_transmitted_force, relative to the impact speed",
                      .absent = "if there is no free body"})},
      {"energy_absorbed_fraction", "Energy absorbed by the pad", "", "1",
       "fraction of the impact energy that remains in neither the impactor nor the support and its moving "
       "parts at the end; negative if the pad returns more energy than it received",
       "Eq. 30", Part::impact,
       main_response({.row = 13, .is_signed = true, .estimate = "relative to the impact energy"})},
      {"energy_residual_fraction", "Energy residual", "", "1",
       "fraction of the impact energy that the numerical solution does not account for; positive or negative",
       "Eq. 30", Part::impact},
      // --- The pulse ---
      {"hic15", "HIC15", "HIC15", "1", "head injury criterion for windows of at most 15 ms, in g^2.5 s",
       "injury.md, HIC", Part::pulse, measure(Doubt::of_hic)},
      {"hic36", "HIC36", "HIC36", "1", "head injury criterion for windows of at most 36 ms, in g^2.5 s",
       "injury.md, HIC", Part::pulse, measure(Doubt::of_hic)},
      {"hic_unlimited", "Unlimited HIC", "HIC", "1",
       "head injury criterion for windows of any length, in g^2.5 s", "injury.md, HIC", Part::pulse,
       measure(Doubt::of_hic)},
      {"hic_d", "HIC(d)", "HIC(d)", "1", "0.75446 HIC36 + 166.4, for the free-motion headform",
       "injury.md, HIC", Part::pulse, measure(Doubt::of_hic_d, false)},
      {"clip_3ms", "3 ms clip", "a_3ms", "m/s2",
       "highest acceleration magnitude sustained for 3 ms without interruption", "injury.md, Clips",
       Part::pulse, measure(Doubt::of_acceleration)},
      {"cumulative_3ms", "Cumulative 3 ms clip", "", "m/s2",
       "highest acceleration magnitude sustained for a total of 3 ms, in one or more intervals",
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
       "time from the moment the acceleration first reaches 5 % of its peak to the peak; for pulses that are "
       "not aligned, the time of the peak",
       "injury.md, Two pulses", Part::pulse, ResultRole{.estimate = by_coarser_run}},
      {"half_peak_width", "Width at half peak", "", "s",
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
      {"support_loss", "Energy lost in the support", "", "J",
       "energy lost in the support through crushing and damping", "Eq. 30", Part::energy},
      {"moving_energy", "Energy of the moving support", "", "J",
       "kinetic energy of the panel and of the body behind the support", "Eq. 30", Part::energy},
      {"pad_energy", "Work on the pad", "", "J", "energy stored and lost in the pad", "Eq. 30", Part::energy},
      {"sheet_energy", "Energy of the sheet", "", "J",
       "energy given to a sheet on the pad: lost in the collision with the nose, or carried away by the "
       "sheet",
       "Eq. 56", Part::energy},
      {"residual_energy", "Residual energy", "", "J",
       "energy that the numerical solution does not account for, positive or negative: impact energy plus "
       "work done by gravity, minus all the other energies",
       "Eq. 30", Part::energy},
      {"total_energy", "Sum of energies", "", "J",
       "sum for impactor, support and pad, minus the work done by gravity", "Eq. 30", Part::energy},
      // --- The history ---
      {"time", "Time", "t", "s", "time from first contact, or as recorded", "", Part::history},
      {"force", "Force", "F", "N", "force on the impactor, positive in compression", "Eq. 6", Part::history},
      {"pad_force", "Pad force", "", "N",
       "force of the foam under a sheet that has mass; the sheet takes up part of the force on the impactor",
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
       "displacement of the impactor from first contact, positive towards the pad", "Eq. 1", Part::history},
      {"penetration", "Penetration", "Y", "m", "penetration into the pad, on the axis", "Eq. 4",
       Part::history},
      {"support_deflection", "Deflection of the support", "X_s", "m",
       "displacement of the impactor minus the penetration and the displacement of a body behind the support",
       "Eq. 4", Part::history},
      {"transmitted_force", "Force behind the support", "T", "N",
       "force exerted by the support on the ground or on the body behind it", "Eq. 41", Part::history},
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
