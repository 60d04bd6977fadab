#pragma once
/// The figures of the validation, and the series and notes that they share. Units are those of the report.

#include <functional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad::report1986 {

using output::Panel;
using output::Series;
using output::SeriesStyle;

/// The content of a figure. Its name, title and source are in the list of all figures.
struct Drawing {
  std::vector<Panel> panels;
  std::string note;
};

// Measurements (report, section 3)
Drawing support_curves(const Study& study);      // 3-3
Drawing time_to_peak(const Study& study);        // 3-4
Drawing nominal_stress(const Study& study);      // 3-5
Drawing force_over_speed(const Study& study);    // 3-6
Drawing rebound_over_speed(const Study& study);  // 3-7
Drawing force_over_energy(const Study& study);   // 3-8
Drawing curves_a_and_b(const Study& study);      // 3-9

// Predictions (report, section 4)
Drawing predicted_time(const Study& study);                  // 4-1
Drawing predicted_force_on_load_cell(const Study& study);    // 4-2
Drawing predicted_force_on_plate(const Study& study);        // 4-3
Drawing predicted_rebound_on_load_cell(const Study& study);  // 4-4
Drawing predicted_rebound_on_plate(const Study& study);      // 4-5

/// Colours and shapes that mean the same in all figures.
namespace palette_index {
inline constexpr std::size_t accurate = 0, printed_1984 = 1, report = 2, second = 3, mended_1984 = 4,
                             first_slope = 5, measured = 6;
}  // namespace palette_index

struct TestGroup {
  Projectile projectile = Projectile::aluminium;
  TestSupport support = TestSupport::load_cell;
};

namespace test_group {
inline constexpr TestGroup aluminium{Projectile::aluminium, TestSupport::load_cell};
inline constexpr TestGroup steel{Projectile::steel, TestSupport::load_cell};
inline constexpr TestGroup on_plate{Projectile::aluminium, TestSupport::plate};
}  // namespace test_group

/// Speeds that the figures show, mph.
inline constexpr double min_speed = 9, greatest_speed = 21;

/// A panel with the initial speed on the horizontal axis; the vertical one begins at 0.
Panel speed_panel(const std::string& title, const std::string& label);
Panel speed_panel(const std::string& title, Quantity quantity);
/// One panel per projectile on the load cell.
std::vector<Panel> both_projectiles(const Study& study,
                                    Panel (*panel_of)(const Study&, const char* title, TestGroup group));

/// The certain readings over speed.
Series measured_points(const Study& study, TestGroup group, Quantity quantity, const std::string& label,
                       std::size_t palette_index);

/// Predictions over speed at the radius that the report simulated with: a line, or points for the program of
/// 1984. The accurate solver also has a dashed line at the favoured radius and a band over the radii.
std::vector<Series> predicted_lines(const Study& study, const std::vector<Program>& shown, TestGroup group,
                                    Quantity quantity);

/// A function on an even grid.
Series function_line(const std::string& label, std::size_t palette_index, double low, double high,
                     const std::function<double(double)>& value, SeriesStyle style = SeriesStyle::line);
/// A function of speed, over all speeds that are shown.
Series speed_line(const std::string& label, std::size_t palette_index,
                  const std::function<double(double)>& value, SeriesStyle style = SeriesStyle::line);

/// The trend of Eq. 36 as peak force over speed (curve "A"), or its estimate for the plate (curve "B");
/// dashed below the energies to which the trend was fitted.
std::vector<Series> curve_a(const Study& study, Projectile projectile, std::size_t palette_index);
std::vector<Series> curve_b(const Study& study, Projectile projectile, std::size_t palette_index);
inline constexpr const char* curve_note =
    "Curves A and B are dashed below 300 in·lb, where Eq. 36 was not fitted; there, curve A for the "
    "aluminium projectile has a tail through tests 1 and 24. ";

const MeasuredTest& test_of(const Study& study, int number);

/// "16 readings of peak force whose test is unknown are left out." Empty if there are none.
std::string lost_readings(const Study& study, const std::string& column, const std::string& what);

/// The radii of the predictions, and their origin.
std::string radius_note(const Study& study);

}  // namespace dashpad::report1986
