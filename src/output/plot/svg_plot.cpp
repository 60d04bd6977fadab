#include "output/plot/svg_plot.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "output/plot/panel_svg.hpp"
#include "output/plot/text_sizes.hpp"
#include "output/svg/svg.hpp"
#include "output/svg/text.hpp"
#include "output/svg/text_fit.hpp"

namespace dashpad::output {

namespace {

// All px.
constexpr double title_line = 26, below_title = 6, source_line = 16;
constexpr double least_right_margin = 24;

/// Lines of text from `top` on.
std::string text_lines(const std::vector<std::string>& lines, const char* name, double top,
                       double line_height) {
  std::string text;
  for (const std::string& line : lines) {
    top += line_height;
    text += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", name, px(plot_edge),
                        px(top - 0.3 * line_height), xml_text(line));
  }
  return text;
}

std::vector<PanelFrame> frames_of(const Plot& plot, const PlotDrawing& drawing, double plot_width) {
  std::vector<PanelFrame> frames;
  for (std::size_t panel = 0; panel < plot.panels.size(); ++panel)
    frames.emplace_back(plot.panels[panel], drawing.panels[panel], plot_width);
  return frames;
}

/// Sets the widths of the axes and places the names in them: the axes of all begin at the same place, which
/// this returns, and end at the same.
double set_widths(std::vector<PanelFrame>& frames, double plot_width) {
  double left = 0, right = least_right_margin;
  for (const PanelFrame& frame : frames) {
    left = std::max(left, plot_edge + frame.left_margin());
    right = std::max(right, plot_edge + width_beside_axes(frame.ends));
  }
  for (PanelFrame& frame : frames) frame.place_across(left, plot_width - left - right);
  return left;
}

Legend legend_of(const std::vector<PanelFrame>& frames) {
  Legend legend;
  for (const PanelFrame& frame : frames)
    for (const LegendEntry& entry : frame.not_named()) add_to(legend.entries, entry);
  return legend;
}

std::string name_of(const Plot& plot) {
  if (!plot.title.empty()) return plot.title;
  return plot.panels.front().title.empty() ? "Plot" : plot.panels.front().title;
}

}  // namespace

std::string svg_plot(const Plot& plot, PlotStyle style, double plot_width) {
  const double text_width_of_plot = plot_width - 2 * plot_edge;
  const PlotDrawing drawing = drawing_of(plot);
  const std::vector<std::string> title =
      lines_within(plot.title, size_for_bold * title_text, text_width_of_plot);
  const std::vector<std::string> source = lines_within(plot.source, source_text, text_width_of_plot);
  std::vector<PanelFrame> frames = frames_of(plot, drawing, plot_width);
  const double left = set_widths(frames, plot_width);
  const Legend legend = legend_of(frames);

  double height = plot_edge;
  std::string body = text_lines(title, "dp-title", height, title_line);
  height += title_line * static_cast<double>(title.size()) + (title.empty() ? 0 : below_title);
  for (const PanelFrame& frame : frames) {
    height += frame.above_axes();
    body += panel_svg(frame, left, height, plot_edge);
    height += frame.scale.size.height + frame.below_axes();
  }
  body += legend.svg(plot_edge, height, text_width_of_plot);
  height += legend.height(text_width_of_plot) + plot_edge / 2;
  body += text_lines(source, "dp-source", height, source_line);
  height += source_line * static_cast<double>(source.size()) + plot_edge / 2;

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"dp-plot\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\">\n<title>{2}</title>\n",
      px(plot_width), px(height), xml_text(name_of(plot)));
  if (style != PlotStyle::none) svg += fmt::format("<style>{}</style>\n", style_sheet(style));
  svg += fmt::format("<rect class=\"dp-paper\" width=\"{}\" height=\"{}\"/>\n", px(plot_width), px(height));
  return svg + body + "</svg>\n";
}

}  // namespace dashpad::output
