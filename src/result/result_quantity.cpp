#include "dashpad/result/result_quantity.hpp"

#include <algorithm>
#include <stdexcept>

namespace dashpad {

const std::vector<ResultQuantity>& result_quantities() {
  // key, title, symbol, SI unit, meaning, source, estimate
  static const std::vector<ResultQuantity> all{
      // --- The impact ---
      {"peak_force", "Peak force", "F_max", "N", "largest force on the impactor", "Eq. 6", true},
      {"peak_acceleration", "Peak acceleration", "a_max", "m/s2",
       "largest magnitude of the acceleration: of an impact, peak force over mass", "Eq. 1", true},
      {"time_to_peak_force", "Time to peak force", "t_F", "s",
       "time of the largest force, from first contact", "Eq. 31", true},
      {"peak_motion", "Peak displacement", "X_max", "m",
       "largest motion of the impactor since first contact: pad and support together", "Eq. 1", true},
      {"peak_penetration", "Peak penetration", "Y_max", "m", "largest penetration into the pad, on the axis",
       "Eq. 4", true},
      {"peak_strain", "Peak strain", "eps_max", "1", "largest strain of the pad, on the axis", "Eq. 5", true},
      {"peak_strain_rate", "Peak strain rate", "", "1/s", "largest magnitude of the strain rate, on the axis",
       "Eq. 5", false},
      {"rebound_speed", "Rebound speed", "V_out", "m/s",
       "speed of the impactor at release, when no column is left under pressure", "Eq. 27", true},
      {"restitution", "Restitution", "e", "1", "rebound speed over impact speed", "", true},
      {"contact_end", "End of contact", "t_c", "s",
       "the force falls below 0.1 % of its peak for the last time", "Eq. 28", true},
      {"release", "Release", "", "s", "no column of the pad is left under pressure", "Eq. 27", false},
      {"force_below_weight", "Force below weight", "", "s",
       "the force falls below the impactor's weight on rebound: the end of the impact in the 1986 report", "",
       true},
      {"bottomed", "Bottomed", "", "s", "the pad is fully compressed on the axis for the first time",
       "Eq. 29", true},
      {"rest", "At rest", "", "s", "the impactor, under its weight, has come to rest on the pad",
       "section 4, Rest", false},
      {"peak_transmitted_force", "Peak force behind", "T_max", "N",
       "largest force of the support on the ground or the body behind it", "Eq. 41", true},
      {"peak_support_deflection", "Peak deflection", "", "m", "largest deflection of the support", "Eq. 41",
       true},
      {"support_set", "Set of the support", "", "m", "deflection of a crushed support that stays", "Eq. 43",
       true},
      {"body_speed", "Speed of the body", "", "m/s",
       "of the free body behind the support, at the end, positive along the impact", "Eq. 42", true},
      {"energy_absorbed_fraction", "Energy absorbed", "", "1",
       "part of the impact energy that the pad has kept: neither impactor nor support nor what moves with it "
       "has it at the end; below zero where more comes out than went in",
       "Eq. 30", true},
      {"energy_residual_fraction", "Energy residual", "", "1",
       "part of the impact energy that the numbers fail to account for, of either sign", "Eq. 30", false},
      // --- The pulse ---
      {"hic15", "HIC15", "HIC15", "1", "head injury criterion, windows of at most 15 ms, in g^2.5 s",
       "injury.md, HIC", true},
      {"hic36", "HIC36", "HIC36", "1", "head injury criterion, windows of at most 36 ms, in g^2.5 s",
       "injury.md, HIC", true},
      {"hic_unlimited", "HIC of any window", "HIC", "1",
       "head injury criterion, windows of any length, in g^2.5 s", "injury.md, HIC", true},
      {"hic_d", "HIC(d)", "HIC(d)", "1", "0.75446 HIC36 + 166.4, of the free-motion headform",
       "injury.md, HIC", true},
      {"clip_3ms", "3 ms clip", "a_3ms", "m/s2",
       "highest magnitude of the acceleration that is held for 3 ms without a break", "injury.md, Clips",
       true},
      {"cumulative_3ms", "Cumulative 3 ms clip", "", "m/s2",
       "highest magnitude of the acceleration that is held for 3 ms in all, its stretches added",
       "injury.md, Clips", true},
      {"severity_index", "Severity index", "SI", "1", "Gadd's severity index, in g^2.5 s",
       "injury.md, Severity index and velocity change", true},
      {"velocity_change", "Velocity change", "dV", "m/s",
       "magnitude of the integral of the acceleration over the pulse",
       "injury.md, Severity index and velocity change", true},
      {"dwell_time", "Dwell time", "", "s",
       "how long the magnitude of the acceleration is above a level, in all", "injury.md, Dwell", true},
      {"time_to_peak", "Time to peak", "", "s",
       "from where the acceleration first reaches 5 % of its peak to the peak; of pulses that are not "
       "aligned, time of the peak",
       "injury.md, Two pulses", true},
      {"half_peak_width", "Width at half the peak", "", "s",
       "how long the magnitude of the acceleration is above half its peak, in all", "injury.md, Two pulses",
       true},
      // --- Energies, at the end of the run or over time ---
      {"impact_energy", "Impact energy", "", "J", "kinetic energy of the impactor at first contact", "Eq. 30",
       false},
      {"weight_work", "Work of the weight", "", "J", "of the impactor", "Eq. 30", false},
      {"kinetic_energy", "Kinetic energy", "", "J", "of the impactor", "Eq. 30", false},
      {"support_energy", "Energy in the support", "", "J", "stored in the support", "Eq. 30", false},
      {"support_loss", "Lost in the support", "", "J", "crushed and damped", "Eq. 30", false},
      {"moving_energy", "Moving support", "", "J", "kinetic energy of the panel and of the body behind",
       "Eq. 30", false},
      {"pad_energy", "Work on the pad", "", "J", "what the pad stores and what it has lost", "Eq. 30", false},
      {"sheet_energy", "Energy of the sheet", "", "J",
       "given to a sheet on the pad: lost where it was struck, or carried away by it", "Eq. 76", false},
      {"residual_energy", "Residual energy", "", "J",
       "what the numbers fail to account for, of either sign: impact and weight less all others", "Eq. 30",
       false},
      {"total_energy", "Sum of energies", "", "J",
       "of impactor, support and pad, less the work of the weight", "Eq. 30", false},
      // --- The history ---
      {"time", "Time", "t", "s", "from first contact, or as a measurement counts it", "", false},
      {"force", "Force", "F", "N", "on the impactor, positive in compression", "Eq. 6", false},
      {"pad_force", "Force of the pad", "", "N",
       "of the foam below a sheet with mass, which takes its share of the force on the impactor", "Eq. 76",
       false},
      {"acceleration", "Acceleration", "dV/dt", "m/s2",
       "of the impactor, positive towards the pad: negative while the pad pushes", "Eq. 1", false},
      {"deceleration", "Deceleration", "-dV/dt", "m/s2",
       "of the impactor, positive away from the pad: positive while the pad pushes", "Eq. 1", false},
      {"velocity", "Velocity", "V", "m/s", "of the impactor, positive towards the pad: negative on rebound",
       "Eq. 1", false},
      {"motion", "Displacement", "X", "m", "of the impactor since first contact, positive towards the pad",
       "Eq. 1", false},
      {"penetration", "Penetration", "Y", "m", "into the pad, on the axis", "Eq. 4", false},
      {"support_deflection", "Deflection of the support", "X_s", "m",
       "displacement less penetration and motion of a body behind", "Eq. 4", false},
      {"transmitted_force", "Force behind the support", "T", "N",
       "of the support on the ground or the body behind it", "Eq. 41", false},
      {"body_motion", "Motion of the body", "", "m", "of the free body behind the support", "Eq. 42", false},
      {"contact_radius", "Contact radius", "r", "m", "outer edge of the stressed area", "Eq. 6", false},
      {"axis_strain", "Strain on the axis", "eps", "1", "of the pad, positive in compression", "Eq. 5",
       false},
  };
  return all;
}

const ResultQuantity* find_result_quantity(std::string_view key) {
  const auto& all = result_quantities();
  const auto found = std::ranges::find_if(all, [&](const ResultQuantity& of) { return key == of.key; });
  return found == all.end() ? nullptr : &*found;
}

const ResultQuantity& result_quantity(std::string_view key) {
  const ResultQuantity* found = find_result_quantity(key);
  if (found == nullptr) throw std::invalid_argument("no quantity of a result: " + std::string{key});
  return *found;
}

std::string title_in_sentence(const ResultQuantity& of) {
  std::string title = of.title;
  const auto is_capital = [&](std::size_t i) { return title[i] >= 'A' && title[i] <= 'Z'; };
  if (title.size() > 1 && is_capital(0) && !is_capital(1)) title[0] = static_cast<char>(title[0] - 'A' + 'a');
  return title;
}

std::string key_with_unit(const ResultQuantity& of, const UnitSystem& units) {
  return name_with_unit(of.key, scaled_unit(of.si_unit, units).unit);
}

}  // namespace dashpad
