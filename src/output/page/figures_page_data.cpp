#include "output/page/figures_page_data.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "dashpad/version.hpp"
#include "output/page/figures_page_series.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using Json = nlohmann::ordered_json;

Json texts(const std::vector<std::string>& lines) {
  Json list = Json::array();
  for (const std::string& line : lines) list.push_back(one_line(line));
  return list;
}

/// As it is, but for what a terminal or page would obey.
std::string lines(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += one_line(text.substr(begin, end - begin)) + '\n';
    begin = end + 1;
  }
  return result;
}

Json table_json(const Table& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) rows.push_back(texts(row));
  return {{"caption", one_line(table.caption)}, {"columns", texts(table.columns)}, {"rows", std::move(rows)}};
}

Json figure_json(const CaptionedPlot& figure) {
  return {{"name", one_line(figure.name)},
          {"title", one_line(figure.plot.title)},
          {"panels", panels_json(figure.plot)},
          {"source", one_line(figure.plot.source)},
          {"note", one_line(figure.note)}};
}

Json range_json(const RangeBar& range) {
  return {{"label", one_line(range.label)},
          {"value", one_line(range.value)},
          {"words", one_line(range.words)},
          {"lowest", one_line(range.lowest)},
          {"highest", one_line(range.highest)},
          {"place", range.place},
          {"from", range.from},
          {"to", range.to},
          {"open_below", range.open_below},
          {"open_above", range.open_above}};
}

Json section_json(const PageSection& section) {
  Json ranges = Json::array(), tables = Json::array(), figures = Json::array();
  for (const RangeBar& range : section.ranges) ranges.push_back(range_json(range));
  for (const Table& table : section.tables) tables.push_back(table_json(table));
  for (const CaptionedPlot& figure : section.figures) figures.push_back(figure_json(figure));
  return {{"heading", one_line(section.heading)}, {"paragraphs", texts(section.paragraphs)},
          {"ranges", std::move(ranges)},          {"tables", std::move(tables)},
          {"figures", std::move(figures)},        {"copy", lines(section.copy)}};
}

}  // namespace

std::string figures_page_data(const FiguresPage& page) {
  Json data;
  data["title"] = one_line(page.title);
  data["summary"] = texts(page.summary);
  data["warnings"] = texts(page.warnings);
  data["program"] = {{"version", version()}, {"commit", build_facts().git_commit}};
  data["sections"] = Json::array();
  for (const PageSection& section : page.sections) data["sections"].push_back(section_json(section));
  std::string text;
  for (const char character : data.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (character == '<')
      text += "\\u003c";
    else
      text += character;
  }
  return text;
}

}  // namespace dashpad::output
