#include "output/page/html.hpp"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "output/plot/axis_ticks.hpp"
#include "output/svg/svg.hpp"

namespace dashpad::output {

namespace {

void check(const Table& table) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row].size() != table.columns.size())
      throw std::invalid_argument(fmt::format("row {} of the table \"{}\" has {} cells, not {}", row + 1,
                                              readable(table.caption), table.rows[row].size(),
                                              table.columns.size()));
  }
}

void check(const RangeBar& range) {
  const auto is_place = [](double share) { return share >= 0 && share <= 1; };
  if (!is_place(range.place) || !is_place(range.from) || !is_place(range.to) || range.to < range.from)
    throw std::invalid_argument(fmt::format("the bar \"{}\" is not between 0 and 1", readable(range.label)));
}

}  // namespace

void check(const Document& page) {
  if (page.lead && page.lead->curve)
    for (const Panel& panel : page.lead->curve->panels) check(panel);
  for (const Section& section : page.sections) {
    for (const RangeBar& range : section.ranges) check(range);
    for (const Table& table : section.tables) check(table);
    for (const CaptionedPlot& figure : section.figures)
      for (const Panel& panel : figure.plot.panels) check(panel);
  }
}

}  // namespace dashpad::output
