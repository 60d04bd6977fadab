// The page of figures: what does not fit together is refused.

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/document.hpp"
#include "output/page/html.hpp"

namespace dashpad::test {

using output::Document;
using output::SeriesStyle;

namespace {

using ::testing::HasSubstr;

Document page_of(const output::Plot& plot) { return {.sections = {{.figures = {{.plot = plot}}}}}; }

Document page_with(const std::vector<output::Series>& series, const output::Axis& x = {},
                   const output::Axis& y = {}) {
  return page_of(output::Plot{.panels = {{.x = x, .y = y, .series = series}}});
}

/// What is said of a page that does not fit together; empty if it does.
std::string fault_of(const Document& page) {
  try {
    output::check(page);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return {};
}

TEST(figures_page, refuses_what_does_not_fit_together) {
  const std::vector<double> one{1}, two{1, 2};
  EXPECT_THAT(fault_of(page_with({{.label = "curve", .x = one, .y = two}})),
              HasSubstr("\"curve\" differ in length"));
  EXPECT_THAT(
      fault_of(page_with({{.label = "band", .style = SeriesStyle::band, .x = two, .y = two, .y2 = one}})),
      HasSubstr("\"band\" differ in length"));
  EXPECT_THAT(fault_of(page_with({}, {.label = "x", .low = 2, .high = 1})),
              HasSubstr("\"x\" ends at 1, which is not above its start at 2"));
  EXPECT_THAT(fault_of(page_with({}, {}, {.label = "y", .logarithmic = true, .low = 0})),
              HasSubstr("\"y\" cannot end at 0"));
  Document page;
  page.sections = {{.tables = {{.caption = "Peaks", .columns = {"a", "b"}, .rows = {{"1", "2"}, {"3"}}}}}};
  EXPECT_EQ(fault_of(page), "row 2 of the table \"Peaks\" has 1 cells, not 2");
  EXPECT_THROW(output::to_html(page), std::invalid_argument);
}

TEST(figures_page, refuses_bars_beyond_their_bounds) {
  Document page;
  page.sections = {{.ranges = {{.label = "modulus", .place = 0.4, .from = 0.2}}}};
  EXPECT_EQ(fault_of(page), "");
  page.sections[0].ranges[0].from = -0.1;
  EXPECT_EQ(fault_of(page), "the bar \"modulus\" is not between 0 and 1");
}

TEST(figures_page, accepts_columns_that_a_style_does_not_use) {
  EXPECT_EQ(fault_of(page_with({{.style = SeriesStyle::vertical_line, .x = {1, 2}, .y = {1}},
                                {.style = SeriesStyle::horizontal_line, .y = {1}},
                                {.x = {1}, .y = {1}, .y2 = {1, 2}}})),
            "");
}

}  // namespace

}  // namespace dashpad::test
