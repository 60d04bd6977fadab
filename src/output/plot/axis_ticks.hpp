#pragma once
/// The points of a series that a picture needs, checks of panels, and the ranges and marks of axes.

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

struct PlotRow {
  double x = 0;
  double y = 0;
  double y2 = 0;  ///< second edge of a band; otherwise equal to y
};

/// A part of a series without a gap.
using PlotRun = std::vector<PlotRow>;

/// The range of the numbers that were included; empty at first.
struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value);
  [[nodiscard]] bool is_empty() const { return low > high; }
};

/// Whether the axis has a place for the number, disregarding its ends.
bool is_drawable(double value, const Axis& axis);
/// Whether it lies within the ends that are given.
bool is_within_limits(double value, const Axis& axis);

/// Throws std::invalid_argument if columns of a series differ in length or an axis cannot have its limits.
void check(const Panel& panel);

/// The runs of a line, band or point series that can be drawn on these axes and are not wholly outside them.
std::vector<PlotRun> drawable_runs(const Series& series, const Axis& x, const Axis& y);

/// Thins a line or band without a visible change: of neighbours within half a pixel in x, the first, last,
/// lowest and highest stay. `span` is what the x axis shows.
PlotRun thinned_line(const PlotRun& run, const Axis& x, const Span& span);

/// Thins points that cover each other: the first within each square of one and a half pixels stays.
PlotRun thinned_points(const PlotRun& run, const Axis& x, const Span& x_span, const Axis& y,
                       const Span& y_span);

struct Tick {
  double value = 0;
  std::string label;  ///< empty: a minor tick of a logarithmic axis
};

/// An axis with both its ends.
struct AxisRange {
  double low = 0;
  double high = 1;
  bool logarithmic = false;

  /// Share of the axis: 0 at its low end, 1 at its high one.
  [[nodiscard]] double share(double value) const;
};

/// The range of an axis. An end without a limit lies at the next mark beyond what is to be included, or half
/// way to it. `most` is the approximate number of labels that have room.
AxisRange range_of(const Axis& axis, const Span& included, std::size_t most);

/// The nearest of 1, 2 and 5 times powers of ten below a positive number, or above it.
double round_number(double value, bool above);

/// The ticks within the range, rising.
std::vector<Tick> ticks_of(const AxisRange& range, std::size_t most);

}  // namespace dashpad::output
