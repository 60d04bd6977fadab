#pragma once
/// Names of lines across a panel, of brackets, of contours, of single points and of lines that end early,
/// written beside them within the axes.

#include <string>
#include <vector>

#include "output/plot/end_labels.hpp"

namespace dashpad::output {

enum class TextAnchor { start, middle, end };

/// In px from the upper left corner of the axes.
struct MarkLabel {
  const SeriesDrawing* series;
  std::string text;
  PlotPlace at = {};  ///< of the base line
  TextAnchor anchor = TextAnchor::start;
};

/// Those that have a place within the axes where they lie neither on each other nor on a line or a point.
/// `ends`: placed, since their leaders are lines too. Names of lines that end far from the right of the axes
/// are taken from there if they have room beside that end.
std::vector<MarkLabel> mark_labels_of(const PanelDrawing& panel, std::vector<EndLabel>& ends,
                                      const PanelScale& scale);

std::string mark_labels_svg(const std::vector<MarkLabel>& labels);

}  // namespace dashpad::output
