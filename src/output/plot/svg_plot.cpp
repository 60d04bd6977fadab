#include "output/plot/svg_plot.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "output/plot/panel_svg.hpp"

namespace dashpad::output {

namespace {

// All px.
constexpr double title_line = 26, below_title = 6, source_line = 16;
constexpr double least_right_margin = 24;

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

/// The legend of what no panel names itself, from `top` on, to which its height is added: in columns as wide
/// as the longest label needs; a label that has no room in the whole width goes on in further lines.
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

}  // namespace

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
