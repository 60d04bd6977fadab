#pragma once
/// One function a figure of the validation.

#include "report1986/validation_series.hpp"

namespace dashpad::report1986 {

// Measurements (report, section 3)
ValidationFigure support_curves(const Study& study);      // 3-3
ValidationFigure time_to_peak(const Study& study);        // 3-4
ValidationFigure nominal_stress(const Study& study);      // 3-5
ValidationFigure force_over_speed(const Study& study);    // 3-6
ValidationFigure rebound_over_speed(const Study& study);  // 3-7
ValidationFigure force_over_energy(const Study& study);   // 3-8
ValidationFigure curves_a_and_b(const Study& study);      // 3-9

// Predictions (report, section 4)
ValidationFigure predicted_time(const Study& study);                  // 4-1
ValidationFigure predicted_force_on_load_cell(const Study& study);    // 4-2
ValidationFigure predicted_force_on_plate(const Study& study);        // 4-3
ValidationFigure predicted_rebound_on_load_cell(const Study& study);  // 4-4
ValidationFigure predicted_rebound_on_plate(const Study& study);      // 4-5

// Ours
ValidationFigure misfit_over_radius(const Study& study);
ValidationFigure force_ratio(const Study& study);

/// The trend of Eq. 36 as peak force over speed (curve "A") or its estimate for the plate (curve "B"), as far
/// up as `greatest_speed`; dashed below the energies for which the trend was fitted.
std::vector<output::Series> curve_a(const Study& study, Projectile projectile, std::size_t turn);
std::vector<output::Series> curve_b(const Study& study, Projectile projectile, std::size_t turn);
inline constexpr const char* curve_note =
    "Curves A and B are dashed below 300 in·lb, where Eq. 36 was not fitted; curve A of the aluminium "
    "projectile has a tail through tests 1 and 24 there. ";

}  // namespace dashpad::report1986
