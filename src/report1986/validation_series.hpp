#pragma once
/// The series that several figures of the validation share. Units are the report's.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad::report1986 {

/// Colours and shapes that mean the same in all figures.
namespace turn {
inline constexpr std::size_t accurate = 0, printed_1984 = 1, report = 2, second = 3, mended_1984 = 4,
                             first_slope = 5, measured = 6;
}  // namespace turn

/// The tests of a projectile on a support.
struct TestGroup {
  Projectile projectile = Projectile::aluminium;
  TestSupport support = TestSupport::load_cell;
};

namespace test_group {
inline constexpr TestGroup aluminium{Projectile::aluminium, TestSupport::load_cell};
inline constexpr TestGroup steel{Projectile::steel, TestSupport::load_cell};
inline constexpr TestGroup on_plate{Projectile::aluminium, TestSupport::plate};
}  // namespace test_group

/// "Peak force (lb)".
std::string axis_label(Quantity quantity);

/// The certain readings over speed.
output::Series measured_points(const Study& study, TestGroup group, Quantity quantity,
                               const std::string& label, std::size_t turn);

/// The prediction over speed at the radius that the report simulated with, a line, for the program of 1984
/// points; for the accurate solver also at the favoured radius, dashed, and with a band over the radii.
std::vector<output::Series> predicted_lines(const Study& study, Program program, TestGroup group,
                                            Quantity quantity);
/// The same for several programs, in their order.
std::vector<output::Series> predicted_lines(const Study& study, const std::vector<Program>& shown,
                                            TestGroup group, Quantity quantity);

/// A function over an even grid.
output::Series function_line(const std::string& label, std::size_t turn, double low, double high,
                             const std::function<double(double)>& value,
                             output::SeriesStyle style = output::SeriesStyle::line);

/// The fitted constant of that name, the first if there are several; none if there is none.
const FittedConstant* fitted(const Study& study, const std::string& name);

const MeasuredTest& test_of(const Study& study, int number);

/// The test of the report and the version: "Measured: Crash Padding Research, Volume III (1986), ...".
std::string source_line(const std::string& where);

/// "16 readings of peak force whose test is lost are left out." Empty if there are none.
std::string lost_readings(const Study& study, const std::vector<std::string>& columns,
                          const std::string& what);

/// Which radii the predictions are at, and why.
std::string radius_note(const Study& study);

/// Speeds that the figures show, mph.
inline constexpr double least_speed = 9, greatest_speed = 21;

}  // namespace dashpad::report1986
