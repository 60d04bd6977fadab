#include "output/page/html.hpp"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/page/cell.hpp"
#include "output/plot/looks.hpp"
#include "output/plot/rows.hpp"
#include "output/plot/svg_plot.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string text_of(const std::string& text) { return xml_text(one_line(text)); }

std::string paragraphs(const std::vector<std::string>& texts) {
  std::string html;
  for (const std::string& text : texts) html += "<p>" + text_of(text) + "</p>\n";
  return html;
}

const char* class_of(Tone tone) {
  switch (tone) {
    case Tone::good: return "good";
    case Tone::doubtful: return "doubtful";
    case Tone::bad: return "bad";
    case Tone::plain: break;
  }
  return "plain";
}

/// Lines stay lines.
std::string xml_lines(const std::string& text) {
  std::string html;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    html += xml_text(rest.substr(0, end)) + "\n";
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  }
  return html;
}

/// Beside the colour, which not all see.
const char* sign_of(Tone tone) {
  switch (tone) {
    case Tone::good: return "✓";
    case Tone::doubtful: return "?";
    case Tone::bad: return "✕";
    case Tone::plain: break;
  }
  return "";
}

/// Bars show values up to this multiple of their limit.
constexpr double longest_bar = 1.3;

std::string bar_of(const KeyFigure& figure) {
  if (!figure.share) return "";
  const double length = 100 * std::clamp(*figure.share / longest_bar, 0.0, 1.0);
  return fmt::format(
      "<svg class=\"limit\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" role=\"img\" "
      "aria-label=\"{:.0f} % of "
      "the limit\"><rect class=\"track\" width=\"100\" height=\"10\"/><rect class=\"{}\" width=\"{}\" "
      "height=\"10\"/>"
      "<rect class=\"at\" x=\"{}\" width=\"0.8\" height=\"10\"/></svg>\n",
      100 * *figure.share, class_of(figure.tone), px(length), px(100 / longest_bar - 0.4));
}

std::string key_figure(const KeyFigure& figure) {
  const char* const sign = sign_of(figure.tone);
  std::string html = fmt::format("<li class=\"{}\"><span class=\"label\">{}</span>\n<b>{}{}</b>\n",
                                 class_of(figure.tone), text_of(figure.label), text_of(figure.value),
                                 *sign == 0 ? "" : fmt::format(" <span class=\"sign\">{}</span>", sign));
  html += bar_of(figure);
  if (!figure.limit.empty()) html += "<span class=\"remark\">" + text_of(figure.limit) + "</span>\n";
  return html + "</li>\n";
}

bool has_something_to_draw(const Plot& plot) {
  return std::ranges::any_of(plot.panels, [](const Panel& panel) {
    return std::ranges::any_of(panel.series, [&](const Series& series) {
      return is_marker(series.style) || !drawable_runs(series, panel.x, panel.y).empty();
    });
  });
}

// --- What the script draws anew ---

std::string warning(const std::string& line) {
  const std::string text = one_line(line);
  const auto is_capital = [](char c) { return (c >= 'A' && c <= 'Z') || c == ' '; };
  auto end = static_cast<std::size_t>(std::ranges::find_if_not(text, is_capital) - text.begin());
  while (end > 0 && text[end - 1] == ' ') --end;
  if (end < 2) end = 0;
  return "<li><strong>" + xml_text(text.substr(0, end)) + "</strong>" + xml_text(text.substr(end)) +
         "</li>\n";
}

std::string range(const RangeBar& of) {
  return fmt::format(
      "<li><p class=\"name\"><span>{}</span><b>{}</b></p>\n<svg class=\"limit\" viewBox=\"0 0 100 10\" "
      "preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{}\"><rect class=\"track\" width=\"100\" "
      "height=\"10\"/>"
      "<rect class=\"interval\" x=\"{}\" width=\"{}\" height=\"10\"/><rect class=\"at\" x=\"{}\" "
      "width=\"0.8\" "
      "height=\"10\"/></svg>\n<p class=\"ends\"><span>{}</span><span "
      "class=\"words\">{}</span><span>{}</span></p></li>\n",
      text_of(of.label), text_of(of.value), text_of(of.words), px(100 * of.from), px(100 * (of.to - of.from)),
      px(std::clamp(100 * of.place - 0.4, 0.0, 99.2)), text_of(of.lowest), text_of(of.words),
      text_of(of.highest));
}

std::string table(const Table& of) {
  std::string html = "<div class=\"table\"><table>\n";
  if (!of.caption.empty()) html += "<caption>" + text_of(of.caption) + "</caption>\n";
  const bool has_head =
      std::ranges::any_of(of.columns, [](const std::string& text) { return !text.empty(); });
  if (has_head) {
    html += "<thead><tr>";
    for (std::size_t i = 0; i < of.columns.size(); ++i)
      html += fmt::format("<th scope=\"col\"{}>{}</th>",
                          i > 0 && is_column_of_numbers(of, i) ? " class=\"number\"" : "",
                          text_of(of.columns[i]));
    html += "</tr></thead>\n";
  }
  html += "<tbody>\n";
  for (const auto& row : of.rows) {
    if (row.empty()) continue;
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += i == 0 ? "<th scope=\"row\">" + text_of(row[i]) + "</th>"
                     : fmt::format("<td data-column=\"{}\"{}>{}</td>",
                                   i < of.columns.size() ? text_of(of.columns[i]) : "",
                                   is_number_or_none(row[i]) ? " class=\"number\"" : "", text_of(row[i]));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string heading_of(const CaptionedPlot& of) {
  const std::string both = of.name.empty() || of.plot.title.empty() ? "" : ": ";
  return one_line(of.name) + both + one_line(of.plot.title);
}

/// More single points make a page heavy and show nothing else: what is left out is in the script's data.
constexpr std::size_t most_static_points = 1000;

/// Leaves points out of series that have too many, evenly; returns for how many one stands at the most.
std::size_t thin_points(Plot& plot) {
  std::size_t most = 1;
  for (Panel& panel : plot.panels)
    for (Series& series : panel.series) {
      if (series.style != SeriesStyle::points || series.x.size() <= most_static_points) continue;
      const std::size_t step = (series.x.size() + most_static_points - 1) / most_static_points;
      for (auto* column : {&series.x, &series.y}) {
        for (std::size_t i = 0; i * step < column->size(); ++i) (*column)[i] = (*column)[i * step];
        column->resize((column->size() + step - 1) / step);
      }
      most = std::max(most, step);
    }
  return most;
}

std::string figure(const CaptionedPlot& of, InlineSvgs& svgs) {
  std::string html = "<figure><figcaption><h3>" + xml_text(heading_of(of)) + "</h3></figcaption>\n";
  Plot plot = of.plot;
  plot.title.clear();
  plot.source.clear();
  const std::size_t step = thin_points(plot);
  html += svgs.add(plot, usual_plot_width);
  if (!of.plot.source.empty()) html += "<p class=\"source\">" + text_of(of.plot.source) + "</p>\n";
  if (step > 1) html += fmt::format("<p class=\"note\">Of many points one in {} is drawn here.</p>\n", step);
  if (!of.note.empty()) html += "<p class=\"note\">" + text_of(of.note) + "</p>\n";
  return html + "</figure>\n";
}

std::string section(const PageSection& of, InlineSvgs& svgs) {
  std::string html = "<section>\n";
  if (!of.heading.empty()) html += "<h2>" + text_of(of.heading) + "</h2>\n";
  html += paragraphs(of.paragraphs);
  if (!of.ranges.empty()) {
    html += "<ul class=\"ranges\">\n";
    for (const RangeBar& each : of.ranges) html += range(each);
    html += "</ul>\n";
  }
  for (const Table& each : of.tables) html += table(each);
  if (!of.figures.empty()) {
    html += "<div class=\"plots\">\n";
    for (const CaptionedPlot& each : of.figures) html += figure(each, svgs);
    html += "</div>\n";
  }
  if (!of.copy.empty()) html += "<pre tabindex=\"0\">" + xml_lines(of.copy) + "</pre>\n";
  return html + "</section>\n";
}

std::string title_html(const FiguresPage& page) {
  const std::string& title = page.lead ? page.lead->answer : page.title;
  return title.empty() ? "Dashpad" : text_of(title) + " - Dashpad";
}

/// px: narrow, so that it can be read on a phone.
constexpr double lead_width = 480;

std::string lead_html(const FiguresPage& page, InlineSvgs& svgs) {
  if (!page.lead) return "";
  const Lead& lead = *page.lead;
  const char* const sign = sign_of(lead.tone);
  std::string html = fmt::format("<div class=\"lead\">\n<h1 class=\"{}\">{}{}</h1>\n", class_of(lead.tone),
                                 *sign == 0 ? "" : fmt::format("<span class=\"sign\">{}</span> ", sign),
                                 text_of(lead.answer));
  if (!lead.reservation.empty()) html += "<p class=\"reservation\">" + text_of(lead.reservation) + "</p>\n";
  for (const std::string& line : lead.subject) html += "<p class=\"subject\">" + text_of(line) + "</p>\n";
  if (!lead.drawing.empty() || lead.curve) {
    html += "<div class=\"pictures\">\n";
    if (!lead.drawing.empty())
      html += "<figure class=\"drawing\">" + svgs.add_with_halves(lead.drawing) + "</figure>\n";
    if (lead.curve) html += "<figure>" + svgs.add(*lead.curve, lead_width) + "</figure>\n";
    html += "</div>\n";
  }
  if (!lead.figures.empty()) {
    html += "<ul class=\"key-figures\">\n";
    for (const KeyFigure& each : lead.figures) html += key_figure(each);
    html += "</ul>\n";
  }
  return html + "</div>\n";
}

std::string body_html(const FiguresPage& page, InlineSvgs& svgs) {
  std::string html;
  if (!page.lead) html += "<h1>" + (page.title.empty() ? "Figures" : text_of(page.title)) + "</h1>\n";
  html += paragraphs(page.summary);
  if (!page.warnings.empty()) {
    html += "<ul class=\"warnings\">\n";
    for (const std::string& line : page.warnings) html += warning(line);
    html += "</ul>\n";
  }
  for (const PageSection& each : page.sections) html += section(each, svgs);
  return html + fmt::format("<footer><p>Written by dashpad {}, commit {}.</p></footer>\n",
                            xml_text(version()), xml_text(build_facts().git_commit));
}

}  // namespace

std::string InlineSvgs::add(std::string svg) {
  constexpr std::string_view opening = "<style>", closing = "</style>";
  if (const std::size_t begin = svg.find("<svg"); begin != std::string::npos) svg.erase(0, begin);
  const std::size_t begin = svg.find(opening);
  const std::size_t end = begin == std::string::npos ? begin : svg.find(closing, begin);
  if (end == std::string::npos) return svg;
  const bool is_new = styles_.insert(svg.substr(begin + opening.size(), end - begin - opening.size())).second;
  if (!is_new) svg.erase(begin, end + closing.size() - begin);
  return svg;
}

std::string InlineSvgs::add(const Plot& plot, double width) {
  return has_something_to_draw(plot) ? add(svg_plot(plot, PlotStyle::light_and_dark, width))
                                     : "<p>There is nothing to draw.</p>\n";
}

std::string InlineSvgs::add_with_halves(std::string svg) {
  static const std::regex size(R"re(viewBox="0 0 ([0-9.]+) ([0-9.]+)")re"),
      left(R"re(<g id="([^"]+)-left-half")re");
  std::smatch of_size, name;
  svg = add(std::move(svg));
  if (!std::regex_search(svg, of_size, size) || !std::regex_search(svg, name, left)) return svg;
  // What is written beside the right picture begins where the left one's captions may still go on.
  struct Half {
    const char* name;
    double from, to;
  };
  const double width = std::stod(of_size[1]);
  std::string halves;
  for (const Half& half : {Half{"left-half", 0, 0.52}, Half{"right-half", 0.41, 1}})
    halves += fmt::format(
        "<svg class=\"half\" viewBox=\"{} 0 {} {}\" aria-hidden=\"true\"><use href=\"#{}-{}\"/></svg>\n",
        px(half.from * width), px((half.to - half.from) * width), of_size[2].str(), name[1].str(), half.name);
  return svg + halves;
}

PageHtml html_of(const FiguresPage& page) {
  InlineSvgs svgs;
  PageHtml html{.styles = {}, .title = title_html(page), .lead = lead_html(page, svgs), .body = {}};
  html.body = body_html(page, svgs);
  html.styles = svgs.styles();
  return html;
}

}  // namespace dashpad::output
