#pragma once
/// The style sheet of every plot.

#include <string_view>

namespace dashpad::output {

/// Whoever puts many plots on one page has the sheet there once.
enum class PlotStyle { none, light, light_and_dark };

/// It does not depend on the plot.
std::string_view style_sheet(PlotStyle style);

}  // namespace dashpad::output
