#include "output/plot/panel_svg.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "output/svg/svg.hpp"
#include "output/svg/text_fit.hpp"

namespace dashpad::output {

namespace {

// All px.
constexpr double tick_text = 12, axis_text = 12.5, panel_title_text = 14;
constexpr double tick_length = 5, tick_gap = 8, panel_title_line = 20, axis_title_line = 17;
constexpr double text_width_of_panel = 860;
/// How many labels there is room for, whatever they say.
constexpr std::size_t most_x_labels = 9, most_y_labels = 7;

std::string text_element(const char* classes, double x, double y, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", classes, px(x), px(y),
                     xml_text(text));
}

/// Lines across at the ticks that have a label, or at those that have none.
std::string grid(const PanelFrame& frame, bool minor) {
  const PanelScale& scale = frame.scale;
  std::string path;
  for (const Tick& tick : frame.x_ticks)
    if (tick.label.empty() == minor)
      path += fmt::format("M{} 0V{}", px(scale.across(tick.value)), px(scale.size.height));
  for (const Tick& tick : frame.y_ticks)
    if (tick.label.empty() == minor)
      path += fmt::format("M0 {}H{}", px(scale.down(tick.value)), px(scale.size.width));
  if (path.empty()) return {};
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", minor ? "dp-minor-grid" : "dp-grid", path);
}

std::string axes(const PanelFrame& frame) {
  const PanelScale& scale = frame.scale;
  const double width = scale.size.width, height = scale.size.height;
  std::string path = fmt::format("M0 0V{}H{}", px(height), px(width));
  std::string numbers;
  for (const Tick& tick : frame.x_ticks) {
    if (tick.label.empty()) continue;
    path += fmt::format("M{} {}v{}", px(scale.across(tick.value)), px(height), px(tick_length));
    numbers +=
        text_element("dp-tick dp-centred", scale.across(tick.value), height + tick_length + 13, tick.label);
  }
  for (const Tick& tick : frame.y_ticks) {
    if (tick.label.empty()) continue;
    path += fmt::format("M0 {}h-{}", px(scale.down(tick.value)), px(tick_length));
    numbers += text_element("dp-tick dp-to-end", -tick_gap, scale.down(tick.value) + 4.2, tick.label);
  }
  return fmt::format("<path class=\"dp-axis\" d=\"{}\"/>\n{}", path, numbers);
}

std::string end_labels(const PanelFrame& frame) {
  const PanelScale& scale = frame.scale;
  std::string text;
  for (const EndLabel& label : frame.drawing->end_labels) {
    const double end = std::clamp(scale.across(label.line_end), 0.0, scale.size.width);
    const double y = scale.size.height * (1 - label.height);
    text += fmt::format("<g{}><path class=\"dp-leader\" d=\"M{} {}L{} {}\"/>",
                        colour_attributes(label.colour, "dp-end"), px(end),
                        px(scale.size.height * (1 - label.line_height)),
                        px(scale.size.width + beside_axes - 4), px(y));
    text += text_element("dp-end-label", scale.size.width + beside_axes, y + 4, label.text) + "</g>\n";
  }
  return text;
}

/// Numbers and words that a script needs to read the panel.
std::string data_attributes(const PanelFrame& frame, double left, double top) {
  const AxisRange &x = frame.scale.x, &y = frame.scale.y;
  return fmt::format(
      "data-x-low=\"{}\" data-x-high=\"{}\" data-x-log=\"{:d}\" data-x-label=\"{}\" "
      "data-y-low=\"{}\" data-y-high=\"{}\" data-y-log=\"{:d}\" data-y-label=\"{}\" "
      "data-left=\"{}\" data-top=\"{}\" data-width=\"{}\" data-height=\"{}\"",
      x.low, x.high, x.logarithmic, xml_text(frame.panel->x.label), y.low, y.high, y.logarithmic,
      xml_text(frame.panel->y.label), px(left), px(top), px(frame.scale.size.width),
      px(frame.scale.size.height));
}

std::string titles(const PanelFrame& frame, double left, double top, double edge) {
  std::string text;
  double line = top - frame.above_axes() + 14;
  for (const std::string& title : frame.title) {
    text += text_element("dp-panel-title", edge, line, title);
    line += panel_title_line;
  }
  line = top - 13 - axis_title_line * (static_cast<double>(frame.y_title.size()) - 1);
  for (const std::string& title : frame.y_title) {
    text += text_element("dp-axis-title", edge, line, title);
    line += axis_title_line;
  }
  const PlotSize& size = frame.scale.size;
  return text + text_element("dp-axis-title dp-to-end", left + size.width, top + size.height + 37,
                             fitting(frame.panel->x.label, axis_text, left + size.width - edge));
}

std::string inside(const PanelFrame& frame) {
  const PlotSize& size = frame.scale.size;
  if (!frame.drawing->has_data) {
    return fmt::format("<path class=\"dp-axis\" d=\"M0 0V{}H{}\"/>\n", px(size.height), px(size.width)) +
           text_element("dp-label dp-centred", size.width / 2, size.height / 2, "no data");
  }
  std::string text = grid(frame, true) + grid(frame, false) + axes(frame);
  for (const SeriesDrawing& series : frame.drawing->series) text += series_svg(series, frame.scale);
  return text + end_labels(frame);
}

}  // namespace

PanelFrame::PanelFrame(const Panel& panel_to_draw, const PanelDrawing& drawing_of_panel)
    : panel(&panel_to_draw),
      drawing(&drawing_of_panel),
      scale{.x = range_of(panel->x, drawing->x, most_x_labels),
            .y = range_of(panel->y, drawing->y, most_y_labels),
            .size = {.width = 0, .height = panel_height}},
      x_ticks(ticks_of(scale.x, most_x_labels)),
      y_ticks(ticks_of(scale.y, most_y_labels)),
      title(lines_within(panel->title, size_for_bold * panel_title_text, text_width_of_panel)),
      y_title(lines_within(panel->y.label, axis_text, text_width_of_panel)) {}

double PanelFrame::left_margin() const {
  double longest = 0;
  for (const Tick& tick : y_ticks) longest = std::max(longest, text_room(tick.label, tick_text));
  return longest + tick_gap;
}

double PanelFrame::above_axes() const {
  return 13 + panel_title_line * static_cast<double>(title.size()) +
         axis_title_line * static_cast<double>(y_title.size());
}

double PanelFrame::below_axes() const { return panel->x.label.empty() ? 36 : 54; }

std::string panel_svg(const PanelFrame& frame, double left, double top, double edge) {
  // The inner coordinates begin at the axes, and a script that zooms has something that can hide what leaves
  // them.
  return fmt::format(
      "<g class=\"dp-panel\" {}>\n{}<svg class=\"dp-inside\" x=\"{}\" y=\"{}\" width=\"{}\" "
      "height=\"{}\" overflow=\"visible\">\n{}</svg>\n</g>\n",
      data_attributes(frame, left, top), titles(frame, left, top, edge), px(left), px(top),
      px(frame.scale.size.width), px(frame.scale.size.height), inside(frame));
}

}  // namespace dashpad::output
