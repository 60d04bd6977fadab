#include "output/page/figures_page_series.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "output/page/columns.hpp"
#include "output/plot/looks.hpp"
#include "output/plot/rows.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using Json = nlohmann::ordered_json;

/// More points than a plot has columns of pixels, enlarged three times.
constexpr std::size_t most_points = 5000;

const char* name_of(SeriesStyle style) {
  switch (style) {
    case SeriesStyle::line: return "line";
    case SeriesStyle::solid_line: return "solid";
    case SeriesStyle::dashed_line: return "dashed";
    case SeriesStyle::points: return "points";
    case SeriesStyle::band: return "band";
    case SeriesStyle::area: return "area";
    case SeriesStyle::vertical_line: return "vertical";
    case SeriesStyle::horizontal_line: return "horizontal";
  }
  return "";
}

/// The axis without ends: what lies beyond them stays, for whoever looks at another part.
Axis endless(const Axis& axis) {
  return {.label = axis.label, .logarithmic = axis.logarithmic, .low = {}, .high = {}};
}

std::vector<PlotRun> thinned(std::vector<PlotRun> runs, SeriesStyle style, const Panel& panel) {
  std::size_t size = 0;
  Span x, y;
  for (const PlotRun& run : runs) {
    size += run.size();
    for (const PlotRow& row : run) {
      x.include(row.x);
      y.include(row.y);
    }
  }
  if (size <= most_points || style == SeriesStyle::area) return runs;
  x = {.low = panel.x.low.value_or(x.low), .high = panel.x.high.value_or(x.high)};
  y = {.low = panel.y.low.value_or(y.low), .high = panel.y.high.value_or(y.high)};
  for (PlotRun& run : runs)
    run = style == SeriesStyle::points ? thinned_points(run, panel.x, x, panel.y, y)
                                       : thinned_line(run, panel.x, x);
  return runs;
}

/// A column of all runs, with a null between two of them.
Json column(const std::vector<PlotRun>& runs, double PlotRow::*value) {
  Json numbers = Json::array();
  for (const PlotRun& run : runs) {
    if (!numbers.empty()) numbers.push_back(nullptr);
    for (const PlotRow& row : run) numbers.push_back(rounded(row.*value));
  }
  return numbers;
}

/// The places of lines across the panel that its axis shows.
Json places(const std::vector<double>& values, const Axis& axis) {
  Json numbers = Json::array();
  for (const double value : values) {
    if (is_drawable(value, axis) && value >= axis.low.value_or(value) && value <= axis.high.value_or(value))
      numbers.push_back(rounded(value));
  }
  return numbers;
}

/// The columns of a series; nothing if the panel shows none of it.
std::optional<Json> columns(const Series& series, const Panel& panel) {
  Json result = Json::object();
  if (is_marker(series.style)) {
    const bool is_vertical = series.style == SeriesStyle::vertical_line;
    result[is_vertical ? "x" : "y"] = is_vertical ? places(series.x, panel.x) : places(series.y, panel.y);
    return result.front().empty() ? std::nullopt : std::optional{result};
  }
  if (drawable_runs(series, panel.x, panel.y).empty()) return std::nullopt;
  const auto runs = thinned(drawable_runs(series, endless(panel.x), endless(panel.y)), series.style, panel);
  result["x"] = column(runs, &PlotRow::x);
  result["y"] = column(runs, &PlotRow::y);
  if (series.style == SeriesStyle::band) result["y2"] = column(runs, &PlotRow::y2);
  return result;
}

Json axis_json(const Axis& axis) {
  const auto end = [](const std::optional<double>& limit) { return limit ? rounded(*limit) : Json(nullptr); };
  return {{"label", one_line(axis.label)},
          {"logarithmic", axis.logarithmic},
          {"low", end(axis.low)},
          {"high", end(axis.high)}};
}

Json panel_json(const Panel& panel, Turns& turns) {
  Json list = Json::array();
  for (const Series& series : panel.series) {
    const auto numbers = columns(series, panel);
    if (!numbers) continue;
    Json item{{"label", one_line(series.label)}, {"style", name_of(series.style)}};
    const bool is_grey = is_marker(series.style) && !series.turn;
    item["turn"] = is_grey ? Json(nullptr) : Json(turns.turn_of(series));
    if (series.shade) item["colour"] = colour_of_shade(*series.shade);
    item.update(*numbers);
    list.push_back(std::move(item));
  }
  return {{"title", one_line(panel.title)},
          {"x", axis_json(panel.x)},
          {"y", axis_json(panel.y)},
          {"series", std::move(list)}};
}

}  // namespace

Json panels_json(const Plot& plot) {
  Json list = Json::array();
  Turns turns{plot};
  for (const Panel& panel : plot.panels) list.push_back(panel_json(panel, turns));
  return list;
}

}  // namespace dashpad::output
