// Limited figures over the fall height.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/fall_height.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/version.hpp"
#include "output/text/fall_height_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr int curve_steps = 60;
/// No curve, band or computed figure is drawn above this multiple of the limit, nor an axis beyond it.
constexpr double max_multiple = 2.5;

struct Scale {
  double height = 1, figure = 1, limit = 0;
};

double in_panel(const Scale& scale, double figure) {
  return figure <= max_multiple * scale.limit ? scale.figure * figure : no_value;
}

/// Points and curve of one place, and its band if it is the lowest.
void add_place(Panel& panel, const fall_height::Crossing& crossing, bool is_lowest, std::size_t colour,
               const std::string& name, const Scale& scale) {
  Series points{.label = name, .style = SeriesStyle::points, .palette_index = colour};
  for (const fall_height::Point& point : crossing.points)
    points.add(scale.height * point.height, scale.figure * point.value);
  if (crossing.curve) {
    Series line{.label = "", .style = SeriesStyle::solid_line, .palette_index = colour, .of = name};
    Series band{.label = "95 % interval", .style = SeriesStyle::band, .palette_index = colour};
    double low = crossing.near.front().height, high = crossing.near.back().height;
    if (crossing.height) low = std::min(low, *crossing.height), high = std::max(high, *crossing.height);
    for (int i = 0; i <= curve_steps; ++i) {
      const double height = std::lerp(low, high, static_cast<double>(i) / curve_steps);
      const double value = crossing.curve->at(height);
      line.add(scale.height * height, in_panel(scale, value));
      const double width = crossing.half_width(height);
      if (!std::isfinite(width)) continue;
      band.x.push_back(scale.height * height);
      band.y.push_back(in_panel(scale, value * std::exp(-width)));
      band.y2.push_back(scale.figure * std::min(value * std::exp(width), max_multiple * scale.limit));
    }
    if (band.x.size() > 1 && is_lowest) panel.add(std::move(band));
    panel.add(std::move(line));
  }
  panel.add(std::move(points));
}

void add_computed(Panel& panel, const margin::Answer& computed, std::size_t limit, std::size_t colour,
                  const Scale& scale) {
  Series line{.label = "computed", .style = SeriesStyle::dashed_line, .palette_index = colour};
  for (const margin::Place& place : computed.places)
    line.add(scale.height * place.value, in_panel(scale, place.figures[limit]));
  panel.add(std::move(line));
}

}  // namespace

Plot fall_height_plot(const FallHeightReport& report, const UnitSystem& units) {
  const injury::Standard& standard = standard_of(report);
  Plot plot{.title = fall_height_answer(report, units),
            .source = fmt::format("dashpad {}; {}", version(),
                                  one_line(report.measured ? report.table_file : report.case_file))};
  for (std::size_t i = 0; i < standard.criteria.size(); ++i) {
    const injury::Criterion& criterion = standard.criteria[i];
    const ResultQuantity& quantity = *criterion.quantity;
    const ScaledUnit shown = shown_as(quantity.si_unit, units);
    const Scale scale{unit_of_heights(units).scale, shown.scale, criterion.limit};
    Panel panel{
        .title = injury::title_of(criterion) + " over the fall height",
        .x = {.label = fmt::format("Fall height ({})", unit_of_heights(units).unit)},
        .y = {.label = shown.unit.empty() ? injury::title_of(criterion)
                                          : fmt::format("{} ({})", injury::title_of(criterion), shown.unit),
              .low = 0}};
    std::size_t colour = 0;
    Series height{.label = "", .style = SeriesStyle::vertical_line};
    if (report.measured)
      for (const fall_height::Place& place : report.measured->places) {
        const fall_height::Crossing& crossing = place.crossings[i];
        const std::string name = place_words(place);
        const bool is_lowest = &place == &fall_height::lowest_for(*report.measured, i);
        add_place(panel, crossing, is_lowest, colour++,
                  !name.empty()                           ? name
                  : report.measured->standard.drop_series ? "means"
                                                          : "drops",
                  scale);
        if (crossing.is_enclosed() && is_lowest) height.add(scale.height * *crossing.height, 0);
      }
    if (report.computed) {
      add_computed(panel, *report.computed, i, colour, scale);
      const margin::Turn* const turn = critical_turn(*report.computed);
      if (!report.measured && turn != nullptr && turn->limit == i) height.add(scale.height * turn->value, 0);
    }
    panel.add(Series{
        .label = "limit", .style = SeriesStyle::horizontal_line, .y = {scale.figure * criterion.limit}});
    if (!height.x.empty()) panel.add(std::move(height));
    const bool decides = report.measured && report.measured->decides().criterion == i;
    plot.panels.insert(decides ? plot.panels.begin() : plot.panels.end(), std::move(panel));
  }
  return plot;
}

}  // namespace dashpad::output
