#pragma once
/// The series that several figures of the validation share. Units are the report's.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad {

/// Colours and shapes that mean the same in all figures.
namespace turn {
inline constexpr std::size_t accurate = 0, printed_1984 = 1, report = 2, second = 3, mended_1984 = 4,
                             first_slope = 5, measured = 6;
}  // namespace turn

/// The tests of a projectile on a support.
struct TestGroup {
  validation::Projectile projectile = validation::Projectile::aluminium;
  validation::TestSupport support = validation::TestSupport::load_cell;
};

namespace test_group {
inline constexpr TestGroup aluminium{validation::Projectile::aluminium, validation::TestSupport::load_cell};
inline constexpr TestGroup steel{validation::Projectile::steel, validation::TestSupport::load_cell};
inline constexpr TestGroup on_plate{validation::Projectile::aluminium, validation::TestSupport::plate};
}  // namespace test_group

/// "Peak force (lb)".
std::string axis_label(validation::Quantity quantity);

/// The certain readings over speed.
Series measured_points(const validation::Study& study, TestGroup group, validation::Quantity quantity,
                       const std::string& label, std::size_t turn);

/// The prediction over speed at the radius that the report simulated with, a line, for the program of 1984
/// points; for the accurate solver also at the favoured radius, dashed, and with a band over the radii.
std::vector<Series> predicted_lines(const validation::Study& study, validation::Program program,
                                    TestGroup group, validation::Quantity quantity);
/// The same for several programs, in their order.
std::vector<Series> predicted_lines(const validation::Study& study,
                                    const std::vector<validation::Program>& programs, TestGroup group,
                                    validation::Quantity quantity);

/// A function over an even grid.
Series function_line(const std::string& label, std::size_t turn, double low, double high,
                     const std::function<double(double)>& value, SeriesStyle style = SeriesStyle::line);

/// The fitted constant of that name, the first if there are several; none if there is none.
const validation::FittedConstant* fitted(const validation::Study& study, const std::string& name);

const validation::MeasuredTest& test_of(const validation::Study& study, int number);

/// The test of the report and the version: "Measured: Crash Padding Research, Volume III (1986), ...".
std::string source_line(const std::string& where);

/// "16 readings of peak force whose test is lost are left out." Empty if there are none.
std::string lost_readings(const validation::Study& study, const std::vector<std::string>& columns,
                          const std::string& what);

/// Which radii the predictions are at, and why.
std::string radius_note(const validation::Study& study);

/// Speeds that the figures show, mph.
inline constexpr double least_speed = 9, greatest_speed = 21;

}  // namespace dashpad
