#include "output/page/html_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "output/layout.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

std::string text_html(const std::string& text) { return xml_text(one_line(text)); }

std::string prose_html(const std::string& text) { return xml_text(quantities_whole(one_line(text))); }

std::string paragraphs_html(const std::vector<std::string>& texts) {
  std::string html;
  for (const std::string& text : texts) html += "<p>" + text_html(text) + "</p>\n";
  return html;
}

std::string lines_html(const std::string& text) {
  std::string html;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    html += xml_text(rest.substr(0, end)) + "\n";
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  }
  return html;
}

const char* class_of_tone(Tone tone) {
  constexpr std::array names{"plain", "good", "doubtful", "bad"};
  return names.at(static_cast<std::size_t>(tone));
}

const char* sign_of_tone(Tone tone) {
  constexpr std::array signs{"", "✓", "?", "✕"};
  return signs.at(static_cast<std::size_t>(tone));
}

namespace {

/// Bars show values up to this multiple of their limit.
constexpr double longest_bar = 1.3;

std::string rect(const char* classes, double left, double width, double opacity = 1) {
  return fmt::format("<rect class=\"{}\" x=\"{}\" width=\"{}\" height=\"10\"{}/>", classes, px(left),
                     px(width), opacity < 1 ? fmt::format(" opacity=\"{}\"", px(opacity)) : "");
}

/// A bar from 0 to 100 on its track, with a mark at `place`.
std::string bar(const std::string& what, const std::string& inside, double place) {
  constexpr double width_of_mark = 0.8;
  return fmt::format(
             "<svg class=\"limit\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" role=\"img\" "
             "aria-label=\"{}\">",
             what) +
         rect("track", 0, 100) + inside +
         rect("at", std::clamp(place - width_of_mark / 2, 0.0, 100 - width_of_mark), width_of_mark) +
         "</svg>\n";
}

std::string bar_of(const ValueRow& figure) {
  if (!figure.share) return "";
  const auto place_of = [](double share) { return 100 * std::clamp(share / longest_bar, 0.0, 1.0); };
  std::string words = fmt::format("{:.0f} % of the limit", 100 * *figure.share);
  std::string inside = rect(class_of_tone(figure.tone), 0, place_of(*figure.share));
  if (const auto& range = figure.share_range) {
    words += std::isfinite(range->second)
                 ? fmt::format(", {:.0f} to {:.0f} % including uncertainty", 100 * range->first,
                               100 * range->second)
                 : fmt::format(", {:.0f} % or more including uncertainty", 100 * range->first);
    inside +=
        rect("interval", place_of(range->first), place_of(range->second) - place_of(range->first), 0.55);
  }
  return bar(words, inside, 100 / longest_bar);
}

/// The interval, which fades where it has no end.
std::string interval_of(const RangeBar& range) {
  constexpr int slices = 10;
  const double width = 100 * (range.to - range.from) / slices;
  std::string rects;
  for (int slice = 0; slice < slices; ++slice) {
    const double from_low = (slice + 0.5) / slices, to_high = 1 - from_low;
    double opacity = 0.55;
    if (range.open_below) opacity = std::min(opacity, from_low);
    if (range.open_above) opacity = std::min(opacity, to_high);
    rects += rect("interval", 100 * range.from + slice * width, width, opacity);
  }
  return rects;
}

}  // namespace

std::string key_figure_html(const ValueRow& figure) {
  const char* const sign = sign_of_tone(figure.tone);
  std::string html =
      fmt::format("<li class=\"{}\"><span class=\"label\">{}</span>\n<b>{}{}</b>\n",
                  class_of_tone(figure.tone), text_html(figure.label), prose_html(shown_value(figure)),
                  *sign == 0 ? "" : fmt::format("\u00a0<span class=\"sign\">{}</span>", sign));
  html += bar_of(figure);
  if (const std::string words = words_beside(figure); !words.empty())
    html += "<span class=\"remark\">" + prose_html(words) + "</span>\n";
  return html + "</li>\n";
}

std::string warning_html(const std::string& line) {
  const std::string text = one_line(line);
  const std::size_t end = capitals_in_front(text);
  return "<li><strong>" + xml_text(text.substr(0, end)) + "</strong>" + xml_text(text.substr(end)) +
         "</li>\n";
}

std::string range_html(const RangeBar& range) {
  return fmt::format(
      "<li><p class=\"name\"><span>{}</span><b>{}</b></p>\n{}<p class=\"ends\"><span>{}</span>"
      "<span class=\"words\">{}</span><span>{}</span></p></li>\n",
      text_html(range.label), text_html(range.value),
      bar(text_html(range.words), interval_of(range), 100 * range.place), text_html(range.lowest),
      text_html(range.words), text_html(range.highest));
}

std::string table_html(const Table& table) {
  std::string html = "<div class=\"table\"><table>\n";
  if (!table.caption.empty()) html += "<caption>" + text_html(table.caption) + "</caption>\n";
  const bool has_head =
      std::ranges::any_of(table.columns, [](const std::string& text) { return !text.empty(); });
  if (has_head) {
    html += "<thead><tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      html += fmt::format("<th scope=\"col\"{}>{}</th>",
                          i > 0 && is_column_of_numbers(table, i) ? " class=\"number\"" : "",
                          text_html(table.columns[i]));
    html += "</tr></thead>\n";
  }
  html += "<tbody>\n";
  for (const auto& row : table.rows) {
    if (row.empty()) continue;
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += i == 0 ? "<th scope=\"row\">" + text_html(row[i]) + "</th>"
                     : fmt::format("<td data-column=\"{}\"{}>{}</td>",
                                   i < table.columns.size() ? text_html(table.columns[i]) : "",
                                   // In a table without a head, cells are texts about one subject, even if
                                   // they are numbers.
                                   has_head && is_number_or_none(row[i]) ? " class=\"number\"" : "",
                                   text_html(row[i]));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace dashpad::output
