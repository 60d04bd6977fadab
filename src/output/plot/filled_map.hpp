#pragma once
/// A value over two axes as areas between round levels, each in its colour.

#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// Round values from `least` to `greatest`, both ends covered: steps of 1, 2 or 5 times a power of ten, about
/// nine. Empty where there is no range.
std::vector<double> round_levels(double least, double greatest);

/// "100 to 120 g", and the shade of the class between levels i and i + 1.
Series class_of_levels(const std::vector<double>& levels, std::size_t i, const std::string& unit);

/// Values at the corners of a grid, [line][across]; linear between them on the two triangles of each cell. A
/// cell with a corner without a value (NaN) stays empty. A series for each class that occurs.
std::vector<Series> filled_areas(const std::vector<double>& across, const std::vector<double>& up,
                                 const std::vector<std::vector<double>>& values,
                                 const std::vector<double>& levels, const std::string& unit);

/// The values that no whole cell shows, as dots in the colours of their classes.
std::vector<Series> lone_dots(const std::vector<double>& across, const std::vector<double>& up,
                              const std::vector<std::vector<double>>& values,
                              const std::vector<double>& levels, const std::string& unit);

/// Where the same values are `level`: lines with pale edges, with a gap after each but the last. Empty where
/// they are nowhere.
Series contour(const std::vector<double>& across, const std::vector<double>& up,
               const std::vector<std::vector<double>>& values, double level);

}  // namespace dashpad::output
