#include "output/plot/panel_svg.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "output/plot/svg_plot.hpp"

namespace dashpad::output {

namespace {

// All lengths are in px.
constexpr double tick_length = 5, tick_gap = 8, panel_title_line = 21, axis_title_line = 18;
constexpr double below_numbers = 20, below_panel = 17;  // distances from the axis and from the title
constexpr std::size_t max_y_labels = 7;

/// The height of the axes, px. Narrow plots are less high, but not as flat as wide ones.
double height_of_axes(double plot_width) { return 160 + plot_width * 160 / 900; }

/// The title of an axis, with the name of the axis for scripts that change units.
std::string axis_title(const char* axis, const char* classes, Place place,
                       const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += fmt::format("<text class=\"{}\" data-axis=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", classes, axis,
                        px(place.x), px(place.y), xml_text(line));
    place.y += axis_title_line;
  }
  return text;
}

std::vector<Tick> ticks_of(const Axis& axis, const AxisRange& range, std::size_t most) {
  return axis.has_numbers ? ticks_of(range, most) : std::vector<Tick>{};
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
  return path_element(minor ? "dp-minor-grid" : "dp-grid", path);
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
        text_element("dp-tick dp-centred", {scale.across(tick.value), height + tick_length + 13}, tick.label);
  }
  for (const Tick& tick : frame.y_ticks) {
    if (tick.label.empty()) continue;
    path += fmt::format("M0 {}h-{}", px(scale.down(tick.value)), px(tick_length));
    numbers += text_element("dp-tick dp-to-end", {-tick_gap, scale.down(tick.value) + 4.2}, tick.label);
  }
  return path_element("dp-axis", path) + numbers;
}

/// Numbers and words that a script needs to read the panel.
std::string data_attributes(const PanelFrame& frame) {
  std::string text;
  const auto add = [&](const char* name, const AxisRange& range, const Axis& axis, std::size_t labels) {
    text += fmt::format(
        "data-{0}-low=\"{1}\" data-{0}-high=\"{2}\" data-{0}-log=\"{3:d}\" data-{0}-label=\"{4}\" "
        "data-{0}-most=\"{5}\" ",
        name, range.low, range.high, range.logarithmic, xml_text(axis.label), labels);
    if (!axis.has_numbers) text += fmt::format("data-{}-numbers=\"0\" ", name);
    if (!axis.si_unit.empty())
      text += fmt::format("data-{0}-unit=\"{1}\" data-{0}-per-si=\"{2}\" ", name, xml_text(axis.si_unit),
                          axis.per_si);
  };
  add("x", frame.scale.x, frame.panel->x, frame.x_labels);
  add("y", frame.scale.y, frame.panel->y, max_y_labels);
  return text + fmt::format("data-width=\"{}\" data-height=\"{}\"", px(frame.scale.size.width),
                            px(frame.scale.size.height));
}

std::string titles(const PanelFrame& frame, double left, double top, double edge) {
  const PlotSize& size = frame.scale.size;
  const double above = axis_title_line * (static_cast<double>(frame.y_title.size()) - 1);
  const double below = top + size.height + below_numbers + axis_title_line;
  return text_elements("dp-panel-title", {edge, top - frame.above_axes() + 14}, panel_title_line,
                       frame.title) +
         axis_title("y", "dp-axis-title", {edge, top - 13 - above}, frame.y_title) +
         axis_title("x", "dp-axis-title dp-to-end", {left + size.width, below}, frame.x_title);
}

std::string inside(const PanelFrame& frame) {
  const PlotSize& size = frame.scale.size;
  if (!frame.drawing->has_data)
    return path_element("dp-axis", fmt::format("M0 0V{}H{}", px(size.height), px(size.width))) +
           text_element("dp-label dp-centred", {size.width / 2, size.height / 2}, "no data");
  std::string text = grid(frame, true) + grid(frame, false) + axes(frame);
  for (const SeriesDrawing& series : frame.drawing->series) text += series_svg(series, frame.scale);
  return text + arrows_svg(*frame.drawing, frame.scale) + mark_labels_svg(frame.marks) +
         end_labels_svg(frame.ends, frame.scale);
}

/// "Force" of "Force (kN)", in small letters.
std::string name_on_axis(const std::string& label) {
  std::string name = readable(label.substr(0, label.find(" (")));
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

/// Whether all that has a name, but for lines across and brackets, is one line, called as an axis is.
bool is_named_by_axis(const PanelDrawing& drawing, const Panel& panel) {
  std::size_t lines = 0;
  bool is_axis = true;
  for (const SeriesDrawing& series : drawing.series) {
    if (series.label.empty() || series.looks.is_dot || is_marker(series.looks.style) ||
        series.label_place != LabelPlace::by_style)
      continue;
    ++lines;
    is_axis = is_axis && is_line(series.looks.style) && series.end_label.empty() &&
              (name_on_axis(series.label) == name_on_axis(panel.y.label) ||
               name_on_axis(series.label) == name_on_axis(panel.x.label));
  }
  return lines == 1 && is_axis;
}

}  // namespace

PanelFrame::PanelFrame(const Panel& panel_to_draw, const PanelDrawing& drawing_of_panel, double plot_width)
    : panel(&panel_to_draw),
      drawing(&drawing_of_panel),
      x_labels(plot_width < 480 ? 7 : 9),
      scale{.x = range_of(panel->x, drawing->x, x_labels),
            .y = range_of(panel->y, drawing->y, max_y_labels),
            .size = {.width = 0, .height = height_of_axes(plot_width)}},
      x_ticks(ticks_of(panel->x, scale.x, x_labels)),
      y_ticks(ticks_of(panel->y, scale.y, max_y_labels)),
      title(lines_within(panel->title, size_for_bold * panel_title_text, plot_width - 2 * plot_edge)),
      y_title(lines_within(panel->y.label, axis_text, plot_width - 2 * plot_edge)) {
  if (!is_named_by_axis(*drawing, *panel)) ends = end_labels_of(*drawing, plot_width);
}

double PanelFrame::left_margin() const {
  double longest = 0;
  for (const Tick& tick : y_ticks) longest = std::max(longest, text_room(tick.label, label_text));
  return longest + tick_gap;
}

double PanelFrame::above_axes() const {
  return 13 + panel_title_line * static_cast<double>(title.size()) +
         axis_title_line * static_cast<double>(y_title.size());
}

double PanelFrame::below_axes() const {
  return below_numbers + axis_title_line * static_cast<double>(x_title.size()) + below_panel;
}

void PanelFrame::place_across(double left, double width) {
  scale.size.width = width;
  x_title = lines_within(panel->x.label, axis_text, left + width - plot_edge);
  place(ends, scale);
  marks = mark_labels_of(*drawing, ends, scale);
  make_room(ends, scale.size.height);
}

std::vector<LegendEntry> PanelFrame::not_named() const {
  std::vector<LegendEntry> entries = drawing->named;
  std::erase_if(entries, [this](const LegendEntry& entry) {
    const auto is_of = [&](const auto& label) { return entry_of(*label.series) == entry; };
    return std::ranges::any_of(ends, is_of) || std::ranges::any_of(marks, is_of) ||
           (is_line(entry.looks.style) && is_named_by_axis(*drawing, *panel));
  });
  return entries;
}

std::string panel_svg(const PanelFrame& frame, double left, double top, double edge) {
  // The inner SVG has its origin at the axes, and lets a script that zooms hide what leaves them.
  return fmt::format(
      "<g class=\"dp-panel\" {}>\n{}<svg class=\"dp-inside\" x=\"{}\" y=\"{}\" width=\"{}\" "
      "height=\"{}\" overflow=\"visible\">\n{}</svg>\n</g>\n",
      data_attributes(frame), titles(frame, left, top, edge), px(left), px(top), px(frame.scale.size.width),
      px(frame.scale.size.height), inside(frame));
}

}  // namespace dashpad::output
