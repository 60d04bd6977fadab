#include "output/page/figures_page_data.hpp"

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

Json section_json(const PageSection& section) {
  Json tables = Json::array(), figures = Json::array();
  for (const Table& table : section.tables) tables.push_back(table_json(table));
  for (const CaptionedPlot& figure : section.figures) figures.push_back(figure_json(figure));
  return {{"heading", one_line(section.heading)},
          {"paragraphs", texts(section.paragraphs)},
          {"tables", std::move(tables)},
          {"figures", std::move(figures)}};
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
