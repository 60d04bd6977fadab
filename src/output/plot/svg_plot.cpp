#include "output/plot/svg_plot.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "output/plot/panel_svg.hpp"

namespace dashpad::output {

namespace {

// All lengths are in px.
constexpr double title_line = 26, below_title = 6, source_line = 16;
constexpr double min_right_margin = 24;

/// Gives the axes of all panels the same ends, places the names in them, and returns the left end.
double set_widths(std::vector<PanelFrame>& frames, double plot_width) {
  double left = 0, right = min_right_margin;
  for (const PanelFrame& frame : frames) {
    left = std::max(left, plot_edge + frame.left_margin());
    right = std::max(right, plot_edge + width_beside_axes(frame.ends));
  }
  for (PanelFrame& frame : frames) frame.place_across(left, plot_width - left - right);
  return left;
}

/// The legend of the series that no panel names, from `top` on, to which its height is added. Columns are as
/// wide as the longest label; labels longer than the whole width continue on further lines.
std::string legend_svg(const std::vector<PanelFrame>& frames, double width, double& top) {
  constexpr double row_height = 20, line_height = 17, sample = 38, between_columns = 24;
  std::vector<LegendEntry> entries;
  for (const PanelFrame& frame : frames)
    for (const LegendEntry& entry : frame.not_named()) add_to(entries, entry);
  if (entries.empty()) return {};
  double longest = 0;
  for (const LegendEntry& entry : entries) longest = std::max(longest, text_room(entry.label, axis_text));
  const double column = sample + longest + between_columns;
  const std::size_t columns = std::clamp<std::size_t>(
      static_cast<std::size_t>((width + between_columns) / column), 1, entries.size());
  std::string text = "<g class=\"dp-legend\">\n";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LegendEntry& entry = entries[i];
    const double x = plot_edge + std::min(column, width) * static_cast<double>(i % columns);
    double middle = top + row_height / 2;
    text += fmt::format("<g class=\"dp-entry\" data-label=\"{}\">{}", xml_text(entry.label),
                        sample_svg(entry.looks, x, middle, sample - 8));
    const std::vector<std::string> lines = lines_within(entry.label, axis_text, width - sample);
    for (const std::string& line : lines) {
      text += fmt::format("<text class=\"dp-label\" x=\"{}\" y=\"{}\">{}</text>", px(x + sample),
                          px(middle + 4.5), xml_text(line));
      middle += line_height;
    }
    text += "</g>\n";
    if ((i + 1) % columns == 0 || i + 1 == entries.size())
      top += row_height + line_height * static_cast<double>(lines.size() - 1);
  }
  return text + "</g>\n";
}

std::string name_of(const Plot& plot) {
  if (!plot.title.empty()) return plot.title;
  return plot.panels.front().title.empty() ? "Plot" : plot.panels.front().title;
}

// The colours are those of Okabe and Ito, which the colour-blind can tell apart, without yellow, which is too
// pale on white; they are lighter on dark paper. Text on white is darker than lines. Series use currentColor,
// since not all renderers have variables.
constexpr std::string_view colours = R"(
.dp-plot{font-family:system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
.dp-paper{fill:#fff}
.dp-title{font-weight:600;fill:#1a2028}
.dp-panel-title{font-weight:600;fill:#1a2028}
.dp-axis-title,.dp-label{fill:#1a2028}
.dp-tick{fill:#3c4652;font-variant-numeric:tabular-nums}
.dp-source{fill:#58626e}
.dp-end-label,.dp-mark-label{fill:currentColor}
.dp-mark-label{stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}
.dp-to-end{text-anchor:end}
.dp-centred{text-anchor:middle}
.dp-axis{fill:none;stroke:#58626e}
.dp-grid{fill:none;stroke:#dde1e6}
.dp-minor-grid{fill:none;stroke:#eef0f3}
.dp-line{fill:none;stroke:currentColor;stroke-linejoin:round}
.dp-dash-1{stroke-dasharray:10 4}
.dp-dash-2{stroke-dasharray:3 3}
.dp-dash-3{stroke-dasharray:10 4 2 4}
.dp-dash-4{stroke-dasharray:16 4 2 4 2 4}
.dp-dash-5{stroke-dasharray:6 4 2 2}
.dp-across{stroke-dasharray:5 3}
.dp-band{fill:currentColor;fill-opacity:.22}
.dp-area{fill:currentColor;stroke:currentColor;stroke-width:.7;stroke-linejoin:round}
.dp-disc{fill:none;stroke:currentColor;stroke-width:5.6;stroke-linecap:round}
.dp-dot{fill:none;stroke:currentColor;stroke-width:3.2;stroke-linecap:round}
.dp-shape{fill:currentColor}
.dp-ring{fill:none;stroke:currentColor;stroke-width:1.4}
.dp-leader{fill:none;stroke:currentColor;stroke-width:.8;stroke-dasharray:1.5 2.5}
.dp-casing{color:#fff}
.dp-grey{color:#555}
.dp-turn-0{color:#0072b2}
.dp-turn-1{color:#d55e00}
.dp-turn-2{color:#009e73}
.dp-turn-3{color:#cc79a7}
.dp-turn-4{color:#e69f00}
.dp-turn-5{color:#56b4e9}
.dp-turn-6{color:#000}
.dp-turn-1 text{fill:#b34f00}
.dp-turn-2 text{fill:#007a59}
.dp-turn-3 text{fill:#a34c7c}
.dp-turn-4 text{fill:#8a6000}
.dp-turn-5 text{fill:#1c74ad}
@media screen and (prefers-color-scheme:dark){
.dp-paper{fill:#14181d}
.dp-title,.dp-panel-title,.dp-axis-title,.dp-label{fill:#e6eaef}
.dp-tick,.dp-source{fill:#a3adb8}
.dp-axis{stroke:#a3adb8}
.dp-grid{stroke:#39424d}
.dp-minor-grid{stroke:#232a31}
.dp-casing{color:#14181d}
.dp-mark-label{stroke:#14181d}
.dp-grey{color:#a3adb8}
.dp-turn-0{color:#4aa8e8}
.dp-turn-1{color:#f5874a}
.dp-turn-2{color:#2fc79a}
.dp-turn-3{color:#e79ccb}
.dp-turn-4{color:#f0b840}
.dp-turn-5{color:#a5dcfb}
.dp-turn-6{color:#f2f2f2}
.dp-end text,.dp-mark text{fill:currentColor}
}
)";

/// Font sizes relative to one of them, so that a page can scale them together.
std::string sizes() {
  const auto rule = [](const char* name, double size) {
    return fmt::format(".{}{{font-size:{:.4g}em}}\n", name, size / label_text);
  };
  return fmt::format("\n.dp-plot{{font-size:{}px}}\n", label_text) + rule("dp-title", title_text) +
         rule("dp-panel-title", panel_title_text) + rule("dp-axis-title,.dp-label", axis_text) +
         rule("dp-source", source_text);
}

}  // namespace

std::string_view style_sheet(PlotStyle style) {
  static const std::string all = sizes() + std::string(colours);
  const std::string_view both = all;
  switch (style) {
    case PlotStyle::none: return {};
    case PlotStyle::light: return both.substr(0, both.find("@media"));
    case PlotStyle::light_and_dark: return both;
  }
  return {};
}

std::string svg_plot(const Plot& plot, PlotStyle style, double plot_width) {
  const double text_width = plot_width - 2 * plot_edge;
  const std::vector<PanelDrawing> drawings = drawings_of(plot);
  const std::vector<std::string> title = lines_within(plot.title, size_for_bold * title_text, text_width);
  const std::vector<std::string> source = lines_within(plot.source, source_text, text_width);
  std::vector<PanelFrame> frames;
  for (std::size_t panel = 0; panel < plot.panels.size(); ++panel)
    frames.emplace_back(plot.panels[panel], drawings[panel], plot_width);
  const double left = set_widths(frames, plot_width);

  double height = plot_edge;
  std::string body = text_elements("dp-title", {plot_edge, height + 0.7 * title_line}, title_line, title);
  height += title_line * static_cast<double>(title.size()) + (title.empty() ? 0 : below_title);
  for (const PanelFrame& frame : frames) {
    height += frame.above_axes();
    body += panel_svg(frame, left, height, plot_edge);
    height += frame.scale.size.height + frame.below_axes();
  }
  body += legend_svg(frames, text_width, height);
  height += plot_edge / 2;
  body += text_elements("dp-source", {plot_edge, height + 0.7 * source_line}, source_line, source);
  height += source_line * static_cast<double>(source.size()) + plot_edge / 2;

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"dp-plot\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\">\n<title>{2}</title>\n",
      px(plot_width), px(height), xml_text(name_of(plot)));
  if (style != PlotStyle::none) svg += fmt::format("<style>{}</style>\n", style_sheet(style));
  svg += fmt::format("<rect class=\"dp-paper\" width=\"{}\" height=\"{}\"/>\n", px(plot_width), px(height));
  return svg + body + "</svg>\n";
}

std::optional<PictureFormat> picture_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".pdf") return PictureFormat::pdf;
  return std::nullopt;
}

std::string picture(const Plot& plot, PictureFormat format) {
  for (const Panel& panel : plot.panels) check(panel);
  switch (format) {
    case PictureFormat::svg: return svg_plot(plot, PlotStyle::light_and_dark);
    case PictureFormat::png: return png_of(svg_plot(plot, PlotStyle::light));
    case PictureFormat::pdf: return pdf_of(svg_plot(plot, PlotStyle::light), plot.title);
  }
  return {};
}

}  // namespace dashpad::output
