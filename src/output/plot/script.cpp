#include "output/plot/script.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "output/plot/drawing.hpp"
#include "output/plot/text.hpp"

namespace dashpad::output {

namespace {

// Lengths are in pixels of an SVG at its own size, 96 to an inch.
constexpr int width = 900;
constexpr int left_margin = 96, least_right_margin = 26;
constexpr int edge = 14;
constexpr int title_line = 28, panel_title = 32;
constexpr int axes = 330, below_axes = 58;
constexpr int legend_row = 20;
constexpr int source_height = 16;

constexpr auto grey = "#555555";

class Script {
 public:
  /// Begins with the kind and size of the picture. `right_margin`: of all its panels.
  Script(PictureFormat format, int height, int right_margin);

  template <typename... Values>
  void add(fmt::format_string<Values...> line, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), line, std::forward<Values>(values)...);
    text_ += '\n';
  }

  void add_panel(const Panel& panel, const PanelDrawing& drawing, int top);
  /// Title, legend and source, around a plot of nothing as large as the picture.
  void add_texts(const std::vector<std::string>& title, const Legend& legend, int legend_top,
                 const std::vector<std::string>& source);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void set_up_axes(const Panel& panel, int top);
  void add_range(char name, const Axis& axis, const Span& included);
  void add_lines_across(const SeriesDrawing& series);
  void add_end_labels(const std::vector<EndLabel>& labels);
  std::string data_block(const SeriesDrawing& series);
  [[nodiscard]] double from_top(double pixels) const { return 1 - pixels / height_; }

  int height_;
  int right_margin_;
  double key_spacing_ = 1.3;
  int blocks_ = 0;
  std::string text_;
};

Script::Script(PictureFormat format, int height, int right_margin)
    : height_(height), right_margin_(right_margin) {
  constexpr auto common = "font 'sans-serif,13' background '#ffffff' rounded noenhanced";
  add("set encoding utf8");
  // The scales make the three look alike.
  switch (format) {
    case PictureFormat::svg:
      add("set terminal svg size {},{} {}", width, height_, common);
      key_spacing_ = 1;
      break;
    case PictureFormat::png:
      add("set terminal pngcairo size {},{} fontscale 1.5 linewidth 2 pointscale 2.6 dashlength 2 {}",
          2 * width, 2 * height_, common);
      break;
    case PictureFormat::pdf:
      add("set terminal pdfcairo size {}in,{}in fontscale 0.5625 linewidth 1.5 pointscale 1 dashlength 2 {}",
          width / 96.0, height_ / 96.0, common);
      break;
  }
  add("set multiplot");
}

void Script::set_up_axes(const Panel& panel, int top) {
  const double centre_of_axes = (left_margin + width - right_margin_) / 2.0 / width;
  add("reset");
  add("set lmargin at screen {}", 1.0 * left_margin / width);
  add("set rmargin at screen {}", 1 - 1.0 * right_margin_ / width);
  add("set tmargin at screen {}", from_top(top));
  add("set bmargin at screen {}", from_top(top + axes));
  add("unset key");
  add("set border 3 linewidth 1 linecolor rgb '#444444'");
  add("set tics nomirror out scale 0.6,0.3 textcolor rgb '#000000'");
  add("set xtics offset 0,0.3");
  add("set format '%.10g'");
  add("set grid xtics ytics mxtics mytics linetype 1 linewidth 0.8 linecolor rgb '#d4d4d4', "
      "linetype 1 linewidth 0.5 linecolor rgb '#ebebeb'");
  add("set clip two");
  add("set label {} at screen {}, screen {} center noenhanced font 'sans-serif,14'",
      literal(shortened(panel.title, 90)), centre_of_axes, from_top(top - 14));
  add("set label {} at screen {}, screen {} center noenhanced", literal(shortened(panel.x.label, 95)),
      centre_of_axes, from_top(top + axes + 42));
  add("set label {} at screen {}, screen {} center rotate noenhanced", literal(shortened(panel.y.label, 40)),
      20.0 / width, from_top(top + axes / 2.0));
}

void Script::add_range(char name, const Axis& axis, const Span& included) {
  const auto end = [](const std::optional<double>& limit) { return limit ? fmt::format("{}", *limit) : "*"; };
  std::string low = end(axis.low), high = end(axis.high);
  // "* < 5" is: where the data begin, but not above 5.
  if (!included.is_empty() && !axis.low) low = fmt::format("* < {}", included.low);
  if (!included.is_empty() && !axis.high) high = fmt::format("{} < *", included.high);
  if (axis.logarithmic) add("set logscale {}", name);
  add("set {}range [{}:{}]", name, low, high);
}

void Script::add_lines_across(const SeriesDrawing& series) {
  const std::string_view line = std::string_view{series.looks}.substr(std::string_view{"with lines "}.size());
  for (const double place : series.places) {
    if (series.style == SeriesStyle::vertical_line)
      add("set arrow from first {0}, graph 0 to first {0}, graph 1 nohead {1}", place, line);
    else
      add("set arrow from graph 0, first {0} to graph 1, first {0} nohead {1}", place, line);
  }
}

void Script::add_end_labels(const std::vector<EndLabel>& labels) {
  for (const EndLabel& label : labels) {
    add("set arrow from first {}, graph {} to graph 1.035, graph {} nohead linewidth 0.8 linecolor rgb '{}'",
        label.line_end, label.line_height, label.height, label.colour);
    add("set label {} at graph 1.042, graph {} left noenhanced font 'sans-serif,11' textcolor rgb '{}'",
        literal(label.text), label.height, label.colour);
  }
}

/// Writes the data, and returns the plot command's words for them.
std::string Script::data_block(const SeriesDrawing& series) {
  const std::string name = fmt::format("$data{}", ++blocks_);
  add("{} << END", name);
  for (const PlotRun& run : series.runs) {
    for (const PlotRow& row : run) add("{} {} {}", row.x, row.y, row.y2);
    // An empty row ends the line.
    if (&run != &series.runs.back()) add("");
  }
  add("END");
  const char* columns = series.style == SeriesStyle::band ? "1:2:3" : "1:2";
  return fmt::format("{} using {} notitle {}", name, columns, series.looks);
}

void Script::add_panel(const Panel& panel, const PanelDrawing& drawing, int top) {
  set_up_axes(panel, top);
  if (!drawing.has_data) {
    add("set label 'no data' at graph 0.5, graph 0.5 center textcolor rgb '{}'", grey);
    add("unset tics");
    add("plot [0:1] [0:1] NaN notitle");
    return;
  }
  add_range('x', panel.x, drawing.vertical_lines);
  add_range('y', panel.y, drawing.horizontal_lines);
  std::vector<std::string> plots;
  for (const SeriesDrawing& series : drawing.series) {
    if (series.runs.empty())
      add_lines_across(series);
    else
      plots.push_back(data_block(series));
  }
  add_end_labels(drawing.end_labels);
  add("plot {}", fmt::join(plots, ", "));
}

void Script::add_texts(const std::vector<std::string>& title, const Legend& legend, int legend_top,
                       const std::vector<std::string>& source) {
  add("reset");
  add("set lmargin at screen 0; set bmargin at screen 0; set rmargin at screen 1; set tmargin at screen 1");
  add("unset border; unset tics");
  double middle = edge + title_line / 2.0;
  for (const std::string& line : title) {
    add("set label {} at screen 0.5, screen {} center noenhanced font 'sans-serif,18'", literal(line),
        from_top(middle));
    middle += title_line;
  }
  middle = height_ - edge - source_height * (static_cast<double>(source.size()) - 0.5);
  for (const std::string& line : source) {
    add("set label {} at screen {}, screen {} left noenhanced font 'sans-serif,10' textcolor rgb '{}'",
        literal(line), 1.0 * left_margin / width, from_top(middle), grey);
    middle += source_height;
  }
  add("set key at screen {}, screen {} left top horizontal maxcols {} Left reverse samplen 4.5 spacing {} "
      "noenhanced",
      1.0 * left_margin / width, from_top(legend_top), legend.columns(), key_spacing_);
  std::vector<std::string> plots{"[0:1] [0:1] NaN notitle"};
  for (const LegendEntry& entry : legend.entries)
    plots.push_back(fmt::format("keyentry {} title {}", entry.looks, literal(entry.label)));
  add("plot {}", fmt::join(plots, ", "));
}

}  // namespace

std::string plot_script(const Plot& plot, PictureFormat format) {
  const PlotDrawing drawing = drawing_of(plot);
  const std::vector<std::string> title = lines_of(plot.title, 80);
  const std::vector<std::string> source = lines_of(plot.source, 115);

  std::vector<int> tops;
  int height = edge + title_line * static_cast<int>(title.size());
  for (const Panel& panel : plot.panels) {
    tops.push_back(height + (panel.title.empty() ? edge : panel_title));
    height = tops.back() + axes + below_axes;
  }
  const int legend_top = height;
  height +=
      legend_row * drawing.legend.rows() + edge + source_height * static_cast<int>(source.size()) + edge;

  int right_margin = least_right_margin;
  for (const PanelDrawing& panel : drawing.panels)
    right_margin = std::max(right_margin, width_beside_axes(panel.end_labels));
  Script script{format, height, right_margin};
  for (std::size_t panel = 0; panel < tops.size(); ++panel)
    script.add_panel(plot.panels[panel], drawing.panels[panel], tops[panel]);
  script.add_texts(title, drawing.legend, legend_top, source);
  script.add("unset multiplot");
  return script.text();
}

}  // namespace dashpad::output
