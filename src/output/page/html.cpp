#include "output/page/html.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "dashpad/version.hpp"
#include "output/layout.hpp"
#include "output/page/html_elements.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// px: narrow, so that texts can be read where a plot is as wide as a phone.
constexpr double width_of_plots = 420;
/// Fewer are seen at a glance.
constexpr std::size_t min_figures_with_contents = 10;

/// A part of the page that changes with the units; scripts find it by its name.
std::string part(const std::string& name, const std::string& html) {
  return fmt::format("<div data-part=\"{}\">\n{}</div>\n", name, html);
}

std::string heading_of(const CaptionedPlot& figure) {
  const std::string both = figure.name.empty() || figure.plot.title.empty() ? "" : ": ";
  return one_line(figure.name) + both + one_line(figure.plot.title);
}

/// The largest number of points in a series: more make a page heavy without showing more.
constexpr std::size_t max_points = 1000;

/// Leaves points out of series that have too many, evenly; returns for how many one stands at the most.
std::size_t thin_points(Plot& plot) {
  std::size_t most = 1;
  for (Panel& panel : plot.panels)
    for (Series& series : panel.series) {
      if (series.style != SeriesStyle::points || series.x.size() <= max_points) continue;
      const std::size_t step = (series.x.size() + max_points - 1) / max_points;
      for (auto* column : {&series.x, &series.y}) {
        for (std::size_t i = 0; i * step < column->size(); ++i) (*column)[i] = (*column)[i * step];
        column->resize((column->size() + step - 1) / step);
      }
      most = std::max(most, step);
    }
  return most;
}

/// The plot, with a note if points are left out.
std::string plot_html(Plot plot, InlineSvgs& svgs) {
  const std::size_t step = thin_points(plot);
  std::string html = svgs.add(plot, width_of_plots);
  if (step > 1) html += fmt::format("<p class=\"note\">Only one point in {} is drawn.</p>\n", step);
  return html;
}

std::string figure(const CaptionedPlot& figure, const std::string& id, InlineSvgs& svgs) {
  std::string html = fmt::format("<figure id=\"{}\"><figcaption><h3>{}</h3></figcaption>\n", id,
                                 xml_text(heading_of(figure)));
  Plot plot = figure.plot;
  // The heading says it already.
  if (plot.panels.size() == 1 &&
      heading_of(figure).find(one_line(plot.panels.front().title)) != std::string::npos)
    plot.panels.front().title.clear();
  plot.title.clear();
  plot.source.clear();
  html += plot_html(std::move(plot), svgs);
  if (!figure.plot.source.empty()) html += "<p class=\"source\">" + text_html(figure.plot.source) + "</p>\n";
  if (!figure.note.empty()) html += "<p class=\"note\">" + text_html(figure.note) + "</p>\n";
  return html + "</figure>\n";
}

std::string texts_of(const Section& section) {
  std::string html = paragraphs_html(section.paragraphs);
  if (!section.ranges.empty()) {
    html += "<ul class=\"ranges\">\n";
    for (const RangeBar& each : section.ranges) html += range_html(each);
    html += "</ul>\n";
  }
  const std::vector<Table> tables = tables_of(section);
  if (tables.empty()) return html;
  html += "<div class=\"tables\">\n";
  for (const Table& each : tables) html += table_html(each);
  return html + "</div>\n";
}

std::string section(const Section& section, std::size_t number, InlineSvgs& svgs) {
  std::string html = fmt::format("<section id=\"section-{}\">\n", number);
  if (!section.heading.empty()) html += "<h2>" + text_html(section.heading) + "</h2>\n";
  if (const std::string texts = texts_of(section); !texts.empty())
    html += part(fmt::format("section-{}", number), texts);
  if (!section.figures.empty()) {
    html += "<div class=\"plots\">\n";
    for (std::size_t i = 0; i < section.figures.size(); ++i)
      html += figure(section.figures[i], fmt::format("figure-{}-{}", number, i + 1), svgs);
    html += "</div>\n";
  }
  if (!section.copy.empty()) html += "<pre tabindex=\"0\">" + lines_html(section.copy) + "</pre>\n";
  return html + "</section>\n";
}

std::string contents(const Document& page) {
  std::size_t count = 0;
  std::string list;
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    const Section& section = page.sections[i];
    count += section.figures.size();
    list +=
        fmt::format("<li><a href=\"#section-{0}\">{1}</a>", i + 1,
                    section.heading.empty() ? fmt::format("Section {}", i + 1) : text_html(section.heading));
    if (!section.figures.empty()) list += "<ul>";
    for (std::size_t k = 0; k < section.figures.size(); ++k) {
      const std::string heading = heading_of(section.figures[k]);
      list += fmt::format("<li><a href=\"#figure-{}-{}\">{}</a></li>\n", i + 1, k + 1,
                          heading.empty() ? fmt::format("Figure {}", k + 1) : xml_text(heading));
    }
    list += section.figures.empty() ? "</li>\n" : "</ul></li>\n";
  }
  if (count < min_figures_with_contents) return {};
  return "<nav aria-label=\"Contents\"><details><summary>Contents</summary><ul>\n" + list +
         "</ul></details></nav>\n";
}

/// A heading ends without a stop.
std::string heading_of(const Lead& lead) {
  return lead.answer.substr(0, lead.answer.find_last_not_of('.') + 1);
}

std::string title_html(const Document& page) {
  const std::string title = page.lead ? heading_of(*page.lead) : page.title;
  return title.empty() ? "Dashpad" : text_html(title) + " - Dashpad";
}

std::string answer_part(const Lead& lead, const std::vector<std::string>& warnings) {
  const char* const sign = sign_of_tone(lead.tone);
  std::string html = fmt::format("<h1 class=\"{}\">{}{}</h1>\n", class_of_tone(lead.tone),
                                 *sign == 0 ? "" : fmt::format("<span class=\"sign\">{}</span> ", sign),
                                 prose_html(heading_of(lead)));
  if (!warnings.empty())
    html += fmt::format("<p class=\"reservation\">{}{}</p>\n", text_html(warnings.front()),
                        warnings.size() == 1 ? "" : fmt::format(" (and {} more below)", warnings.size() - 1));
  for (const std::string& line : lead.subject)
    if (!line.empty()) html += "<p class=\"subject\">" + text_html(line) + "</p>\n";
  return part("answer", html);
}

std::string drawing_part(const Lead& lead, InlineSvgs& svgs) {
  if (lead.drawing.empty()) return {};
  return "<figure class=\"drawing\" data-part=\"drawing\">" + svgs.add_with_halves(lead.drawing) +
         "</figure>\n";
}

std::string figures_part(const Lead& lead) {
  if (lead.figures.empty()) return {};
  std::string html = "<ul class=\"key-figures\">\n";
  for (std::size_t i = 0; i < std::min(lead.figures.size(), max_key_figures); ++i)
    html += key_figure_html(lead.figures[i]);
  return part("figures", html + "</ul>\n");
}

std::string lead_html(const Document& page, InlineSvgs& svgs) {
  const Lead& lead = *page.lead;
  std::string html = "<div class=\"lead\">\n" + answer_part(lead, page.warnings);
  if (!lead.drawing.empty() || lead.curve) {
    html += "<div class=\"pictures\">\n" + drawing_part(lead, svgs);
    if (lead.curve) html += "<figure>" + plot_html(*lead.curve, svgs) + "</figure>\n";
    html += "</div>\n";
  }
  return html + figures_part(lead) + "</div>\n";
}

std::string words_part(const Document& page) {
  std::string warnings;
  for (std::size_t i = page.lead ? 1 : 0; i < page.warnings.size(); ++i)
    warnings += warning_html(page.warnings[i]);
  if (!warnings.empty()) warnings = "<ul class=\"warnings\">\n" + warnings + "</ul>\n";
  const std::string html = paragraphs_html(page.summary) + warnings;
  return html.empty() ? html : part("words", html);
}

std::string title_of_system(const UnitSystem& units) {
  if (units.name == "si") return "SI";
  if (units.name == "us") return "US";
  return units.name == "engineering-metric" ? "Engineering metric" : units.name;
}

/// Name, and place among the systems on offer.
std::string units_attributes(const UnitSystem& units) {
  const auto order =
      std::ranges::find(unit_systems(), units.name, &UnitSystem::name) - unit_systems().begin();
  return fmt::format(" data-units=\"{}\" data-order=\"{}\"", xml_text(title_of_system(units)), order);
}

/// Unit and factor for each SI unit that an axis can have.
std::string factors(const UnitSystem& units) {
  nlohmann::ordered_json all;
  for (const char* si : {"m", "s", "m/s", "N", "Pa", "J"})
    all[si] = {shown_unit(unit_for(units, si)), value_in(units, 1, si)};
  return xml_text(all.dump());
}

/// A drawing in other units: its texts, if that is all in which it differs from the one that is shown.
std::string drawing_in_other_units(const Lead& lead, const Lead& shown, InlineSvgs& svgs) {
  if (lead.drawing.empty() || !differ_in_texts_only(lead.drawing, shown.drawing))
    return drawing_part(lead, svgs);
  std::string html;
  for (const std::string& text : texts_in(lead.drawing)) html += "<li>" + text + "</li>\n";
  return "<ul data-texts-of=\"drawing\">\n" + html + "</ul>\n";
}

/// A template that holds all texts of a page in one unit system, for the script to swap in.
std::string units_template(const DocumentInUnits& document_in_units, const Document& shown,
                           InlineSvgs& svgs) {
  const Document& page = document_in_units.document;
  std::string html =
      fmt::format("<template{} data-factors=\"{}\">\n", units_attributes(*document_in_units.units),
                  factors(*document_in_units.units));
  if (page.lead)
    html += answer_part(*page.lead, page.warnings) + drawing_in_other_units(*page.lead, *shown.lead, svgs) +
            figures_part(*page.lead);
  html += words_part(page);
  for (std::size_t i = 0; i < page.sections.size(); ++i)
    if (const std::string texts = texts_of(page.sections[i]); !texts.empty())
      html += part(fmt::format("section-{}", i + 1), texts);
  return html + "</template>\n";
}

std::string main_html(const Document& page, InlineSvgs& svgs) {
  std::string html;
  if (!page.lead) html += "<h1>" + (page.title.empty() ? "Figures" : text_html(page.title)) + "</h1>\n";
  html += words_part(page) + contents(page);
  for (std::size_t i = 0; i < page.sections.size(); ++i) html += section(page.sections[i], i + 1, svgs);
  return html + fmt::format("<footer><p>Written by dashpad {}, commit {}.</p></footer>\n",
                            xml_text(version()), xml_text(build_facts().git_commit));
}

}  // namespace

PageHtml html_of(std::vector<DocumentInUnits> pages) {
  for (DocumentInUnits& each : pages) {
    std::erase_if(each.document.sections,
                  [](const Section& section) { return section.seen == Seen::in_brief; });
    check(each.document);
  }
  const Document& page = pages.front().document;
  InlineSvgs svgs;
  PageHtml html{.styles = {}, .title = title_html(page), .body = {}};
  if (page.lead) html.body = lead_html(page, svgs);
  html.body +=
      fmt::format("<main{}{}>\n{}</main>\n", page.is_one_impact ? " data-one-impact" : "",
                  pages.size() > 1 ? units_attributes(*pages.front().units) : "", main_html(page, svgs));
  for (std::size_t i = 1; i < pages.size(); ++i) html.body += units_template(pages[i], page, svgs);
  html.styles = svgs.styles();
  return html;
}

std::string to_html(std::vector<DocumentInUnits> documents) { return framed(html_of(std::move(documents))); }

std::string to_html(const Document& document) {
  return to_html(std::vector{DocumentInUnits{nullptr, document}});
}

}  // namespace dashpad::output
