#pragma once
/// The figures of a study; empty where the study has none of the kind.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::output {

/// Empirical distribution functions, a panel a response.
std::vector<CaptionedPlot> distribution_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response over each sampled factor.
std::vector<CaptionedPlot> scatter_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response as the colour of its rows over the two sampled factors that it follows most.
std::vector<CaptionedPlot> coloured_scatter_figures(const study::StudyAnswers& answers,
                                                    const UnitSystem& units);
/// Sobol' indices with their intervals.
std::vector<CaptionedPlot> index_figures(const study::StudyAnswers& answers);
/// Each response over one factor of names, as bars.
std::vector<CaptionedPlot> named_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response over the factor with the most levels, a line for each level of the next.
std::vector<CaptionedPlot> curve_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response as coloured areas over two factors with levels.
std::vector<CaptionedPlot> map_figures(const study::StudyAnswers& answers, const UnitSystem& units);
std::vector<CaptionedPlot> cushion_figures(const study::StudyAnswers& answers, const UnitSystem& units);

/// "Thickness of the pad (mm)".
Axis axis_of_factor(const study::Factor& factor, const UnitSystem& units);
/// Lines across at the limits of a response, with their values.
std::vector<Series> limit_lines(const study::StudyAnswers& answers, const std::string& response,
                                SeriesStyle style, const UnitSystem& units);
/// Triangles for rows that bottomed out on a rigid support, whose force is beyond any axis; red by default.
Series struck_through_marks(std::size_t colour = 1);
/// The height for such marks at which they hide no values: slightly above all of them.
double above_all(const std::vector<Series>& series);

/// At most `most` of `count` rows, in their order. They are chosen at random, always the same ones: every
/// n-th row of an even sequence would cover only a part of a factor's range.
std::vector<std::size_t> rows_drawn(std::size_t count, std::size_t most);

/// A response over two factors of a grid, with all other factors at their middle levels. Levels increase.
struct GridPlane {
  std::size_t across = 0;                   ///< factor with the most levels
  std::optional<std::size_t> lines;         ///< the next one
  std::vector<double> across_levels;        ///< SI
  std::vector<double> line_levels;          ///< SI; {0} without a second factor
  std::vector<std::vector<double>> values;  ///< [line][across], SI; NaN for none, infinite: struck through
  /// The 5 % and 95 % quantiles of draws; empty for a grid without draws.
  std::vector<std::vector<double>> low, high;
  std::string at;          ///< levels of the other factors, in words; may be empty
  bool is_median = false;  ///< whether the values are medians of draws, not of single rows
};

/// The plane of a response (index in StudyAnswers::responses). Absent without a numeric factor of two levels.
std::optional<GridPlane> grid_plane(const study::StudyAnswers& answers, std::size_t response,
                                    const UnitSystem& units);

// A value over two axes as areas between round levels, each in its colour.

/// About nine round values that cover the range, in steps of 1, 2 or 5 times a power of ten; of values that
/// differ by more than a factor of 100, such as HIC up to bottoming, by factors.
std::vector<double> round_levels(double least, double greatest);

/// "100 to 120 g", and the shade of the class between levels i and i + 1.
Series class_of_levels(const std::vector<double>& levels, std::size_t i, const std::string& unit);

/// Areas of values at the corners of a grid, [line][across], linear on the two triangles of each cell: a
/// series for each class that occurs. Cells with a missing corner (NaN) stay empty.
std::vector<Series> filled_areas(const std::vector<double>& across, const std::vector<double>& up,
                                 const std::vector<std::vector<double>>& values,
                                 const std::vector<double>& levels, const std::string& unit);

/// The values that no whole cell shows, as dots in the colours of their classes.
std::vector<Series> lone_dots(const std::vector<double>& across, const std::vector<double>& up,
                              const std::vector<std::vector<double>>& values,
                              const std::vector<double>& levels, const std::string& unit);

/// The contour of a level: lines with pale edges and gaps between. Empty if no value crosses it.
Series contour(const std::vector<double>& across, const std::vector<double>& up,
               const std::vector<std::vector<double>>& values, double level);

/// A figure with the version, the number of rows and the title of the study in small print.
CaptionedPlot study_figure(const study::StudyAnswers& answers, std::string title, std::vector<Panel> panels,
                           std::string note = {});

}  // namespace dashpad::output
