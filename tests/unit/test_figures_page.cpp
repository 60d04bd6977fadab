// The page of figures as text: its data are those that were given, no text leaves them, and what does not fit
// together is refused.

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "dashpad/output/page/figures_page.hpp"
#include "dashpad/output/page/page.hpp"
#include "output/page/figures_page_check.hpp"
#include "output/page/figures_page_data.hpp"

namespace dashpad::test {

using output::FiguresPage;
using output::SeriesStyle;

namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

FiguresPage page_of(const output::Plot& plot) { return {.sections = {{.figures = {{.plot = plot}}}}}; }

FiguresPage page_with(const std::vector<output::Series>& series, const output::Axis& x = {},
                      const output::Axis& y = {}) {
  return page_of(output::Plot{.panels = {{.x = x, .y = y, .series = series}}});
}

Json parsed(const FiguresPage& page) { return Json::parse(output::figures_page_data(page)); }

Json panel_of(const FiguresPage& page) { return parsed(page)["sections"][0]["figures"][0]["panels"][0]; }

/// What is said of a page that does not fit together; empty if it does.
std::string fault_of(const FiguresPage& page) {
  try {
    output::check(page);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return {};
}

TEST(figures_page_data, holds_all_texts_in_their_order) {
  FiguresPage page =
      page_with({{.label = "curve", .x = {1, 2}, .y = {3, 4}}}, {.label = "x (m)"}, {.label = "y (N)"});
  page.title = "A title";
  page.summary = {"one", "two"};
  page.warnings = {"EXTRAPOLATED: far"};
  output::PageSection& section = page.sections[0];
  section.heading = "A heading";
  section.paragraphs = {"a paragraph"};
  section.tables = {{.caption = "A table", .columns = {"a", "b"}, .rows = {{"1", "2"}, {"3", "4"}}}};
  section.figures[0].name = "Figure 3-4";
  section.figures[0].note = "a note";
  section.figures[0].plot.title = "A plot";
  section.figures[0].plot.source = "a source";
  section.figures[0].plot.panels[0].title = "A panel";

  const Json data = parsed(page);
  EXPECT_EQ(data["title"], "A title");
  EXPECT_EQ(data["summary"], Json({"one", "two"}));
  EXPECT_EQ(data["warnings"], Json::array({"EXTRAPOLATED: far"}));
  const Json& shown = data["sections"][0];
  EXPECT_EQ(shown["heading"], "A heading");
  EXPECT_EQ(shown["paragraphs"], Json::array({"a paragraph"}));
  EXPECT_EQ(shown["tables"][0]["caption"], "A table");
  EXPECT_EQ(shown["tables"][0]["columns"], Json({"a", "b"}));
  EXPECT_EQ(shown["tables"][0]["rows"], Json::parse(R"([["1","2"],["3","4"]])"));
  const Json& figure = shown["figures"][0];
  EXPECT_EQ(figure["name"], "Figure 3-4");
  EXPECT_EQ(figure["title"], "A plot");
  EXPECT_EQ(figure["source"], "a source");
  EXPECT_EQ(figure["note"], "a note");
  EXPECT_EQ(figure["panels"][0]["title"], "A panel");
  EXPECT_EQ(figure["panels"][0]["x"]["label"], "x (m)");
  EXPECT_EQ(figure["panels"][0]["y"]["label"], "y (N)");
  EXPECT_EQ(figure["panels"][0]["series"][0]["label"], "curve");
}

TEST(figures_page_data, has_seven_digits_and_nulls_for_gaps) {
  const Json panel = panel_of(page_with({{.x = {0, 1.0 / 3, nan, 1, 2}, .y = {1e9 / 7, 2, 3, infinity, 4}}}));
  EXPECT_EQ(panel["series"][0]["x"], Json::parse("[0, 0.3333333, null, 2]"));
  EXPECT_EQ(panel["series"][0]["y"], Json::parse("[142857100, 2, null, 4]"));
  EXPECT_THAT(output::figures_page_data(page_with({{.x = {1.0 / 3}, .y = {1}}})), HasSubstr("[0.3333333]"));
}

TEST(figures_page_data, leaves_loops_in_their_order) {
  const Json series = panel_of(page_with({{.x = {0, 2, 1, 0}, .y = {0, 1, 0.5, 0}}}))["series"][0];
  EXPECT_EQ(series["x"], Json::parse("[0, 2, 1, 0]"));
  EXPECT_EQ(series["y"], Json::parse("[0, 1, 0.5, 0]"));
}

TEST(figures_page_data, names_every_style) {
  const std::vector<double> one{1};
  const Json list = panel_of(page_with({
      {.style = SeriesStyle::line, .x = one, .y = one},
      {.style = SeriesStyle::solid_line, .x = one, .y = one},
      {.style = SeriesStyle::dashed_line, .x = one, .y = one},
      {.style = SeriesStyle::points, .x = one, .y = one},
      {.style = SeriesStyle::band, .x = one, .y = one, .y2 = {2}},
      {.style = SeriesStyle::vertical_line, .x = one},
      {.style = SeriesStyle::horizontal_line, .y = one},
  }))["series"];
  std::vector<std::string> styles;
  for (const Json& series : list) styles.push_back(series["style"]);
  EXPECT_THAT(styles,
              ::testing::ElementsAre("line", "solid", "dashed", "points", "band", "vertical", "horizontal"));
  EXPECT_EQ(list[4]["y2"], Json::array({2}));
  EXPECT_FALSE(list[5].contains("y"));
  EXPECT_FALSE(list[6].contains("x"));
}

TEST(figures_page_data, gives_turns_as_the_stills_do) {
  const std::vector<double> one{1};
  output::Panel first{.series = {{.label = "a", .x = one, .y = one},
                                 {.label = "none", .x = {nan}, .y = one},
                                 {.label = "b", .x = one, .y = one, .turn = 1},
                                 {.label = "c", .x = one, .y = one},
                                 {.style = SeriesStyle::vertical_line, .x = one},
                                 {.style = SeriesStyle::horizontal_line, .y = one, .turn = 0}}};
  output::Panel second{.series = {{.label = "c", .x = one, .y = one}, {.label = "d", .x = one, .y = one}}};
  const Json panels =
      parsed(page_of(output::Plot{.panels = {first, second}}))["sections"][0]["figures"][0]["panels"];
  const auto turns = [](const Json& panel) {
    Json list = Json::array();
    for (const Json& series : panel["series"]) list.push_back(series["turn"]);
    return list;
  };
  // Those without a point are left out, and turns that somebody has are not handed out.
  EXPECT_EQ(turns(panels[0]), Json::parse("[2, 1, 3, null, 0]"));
  EXPECT_EQ(turns(panels[1]), Json::parse("[3, 4]"));
}

TEST(figures_page_data, leaves_a_gap_where_a_logarithmic_axis_has_no_place) {
  const output::Axis logarithmic{.logarithmic = true, .low = 0.5, .high = 100};
  const Json panel = panel_of(page_with({{.x = {1, 2, 3}, .y = {1, 0, 2}},
                                         {.style = SeriesStyle::horizontal_line, .y = {-1, 5, 200}},
                                         {.x = {1, 2}, .y = {200, 300}}},
                                        {}, logarithmic));
  EXPECT_EQ(panel["y"], Json::parse(R"({"label": "", "logarithmic": true, "low": 0.5, "high": 100})"));
  EXPECT_EQ(panel["x"], Json::parse(R"({"label": "", "logarithmic": false, "low": null, "high": null})"));
  ASSERT_EQ(panel["series"].size(), 2U) << "what lies beyond the axis is left out";
  EXPECT_EQ(panel["series"][0]["y"], Json::parse("[1, null, 2]"));
  EXPECT_EQ(panel["series"][1]["y"], Json::array({5}));
}

TEST(figures_page_data, thins_long_columns_but_keeps_their_peaks) {
  std::vector<double> x(400'000), y(x.size(), 1.0);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
  y[234'567] = 7;
  const Json series = panel_of(page_with({{.x = x, .y = y}}))["series"][0];
  EXPECT_LT(series["x"].size(), 10'000U);
  EXPECT_EQ(series["x"].size(), series["y"].size());
  EXPECT_EQ(series["x"].back(), 399'999);
  EXPECT_THAT(series["y"].get<std::vector<double>>(), ::testing::Contains(7));
}

TEST(figures_page_data, keeps_hostile_text_inside) {
  const std::string attack = "</script><script>window.pwned=1</script><!-- \"'\\ \xe2\x80\xa8 &amp;\n\xff";
  const std::string shown = "</script><script>window.pwned=1</script><!-- \"'\\   &amp; \xef\xbf\xbd";
  FiguresPage page = page_with({{.label = attack, .x = {1}, .y = {1}}}, {.label = attack}, {.label = attack});
  page.title = attack;
  page.summary = page.warnings = {attack};
  output::PageSection& section = page.sections[0];
  section.heading = attack;
  section.paragraphs = {attack};
  section.tables = {{.caption = attack, .columns = {attack}, .rows = {{attack}}}};
  output::CaptionedPlot& figure = section.figures[0];
  figure.name = figure.note = figure.plot.title = figure.plot.source = figure.plot.panels[0].title = attack;
  const std::string text = output::figures_page_data(page);
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_THAT(text, Not(HasSubstr("\n")));
  const Json data = Json::parse(text);
  EXPECT_EQ(data["title"], shown);
  EXPECT_EQ(data["sections"][0]["tables"][0]["rows"][0][0], shown);
  EXPECT_EQ(data["sections"][0]["figures"][0]["panels"][0]["series"][0]["label"], shown);
}

TEST(figures_page, refuses_what_does_not_fit_together) {
  const std::vector<double> one{1}, two{1, 2};
  EXPECT_THAT(fault_of(page_with({{.label = "curve", .x = one, .y = two}})),
              HasSubstr("\"curve\" differ in length"));
  EXPECT_THAT(
      fault_of(page_with({{.label = "band", .style = SeriesStyle::band, .x = two, .y = two, .y2 = one}})),
      HasSubstr("\"band\" differ in length"));
  EXPECT_THAT(fault_of(page_with({}, {.label = "x", .low = 2, .high = 1})),
              HasSubstr("\"x\" ends at 1, not above"));
  EXPECT_THAT(fault_of(page_with({}, {}, {.label = "y", .logarithmic = true, .low = 0})),
              HasSubstr("\"y\" cannot end at 0"));
  FiguresPage page;
  page.sections = {{.tables = {{.caption = "Peaks", .columns = {"a", "b"}, .rows = {{"1", "2"}, {"3"}}}}}};
  EXPECT_EQ(fault_of(page), "row 2 of the table \"Peaks\" has 1 cells, not 2");
  EXPECT_THROW(output::figures_page(page), std::invalid_argument);
}

TEST(figures_page, has_bars_between_their_bounds) {
  FiguresPage page;
  page.sections = {
      {.ranges = {{.label = "<b>", .value = "2 kPa", .place = 0.4, .from = 0.2, .open_above = true}}}};
  const Json bar = parsed(page)["sections"][0]["ranges"][0];
  EXPECT_EQ(bar["label"], "<b>");
  EXPECT_EQ(bar["place"], 0.4);
  EXPECT_EQ(bar["from"], 0.2);
  EXPECT_EQ(bar["to"], 1);
  EXPECT_EQ(bar["open_below"], false);
  EXPECT_EQ(bar["open_above"], true);
  page.sections[0].ranges[0].from = -0.1;
  EXPECT_THROW(output::figures_page(page), std::invalid_argument);
}

TEST(figures_page, accepts_columns_that_a_style_does_not_use) {
  EXPECT_EQ(fault_of(page_with({{.style = SeriesStyle::vertical_line, .x = {1, 2}, .y = {1}},
                                {.style = SeriesStyle::horizontal_line, .y = {1}},
                                {.x = {1}, .y = {1}, .y2 = {1, 2}}})),
            "");
}

TEST(figures_page, is_one_file_that_asks_for_no_other) {
  if (!output::has_page()) GTEST_SKIP() << output::no_page;
  const std::string text =
      output::figures_page(page_with({{.label = "</script>", .x = {1, 2}, .y = {1, 2}}}));
  // Without a matcher: it would print the whole page.
  const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(text.starts_with("<!DOCTYPE html>"));
  EXPECT_LT(text.size(), 100'000U);
  EXPECT_TRUE(has("default-src 'none'; script-src 'sha256-"));
  EXPECT_TRUE(has("The MIT License"));
  for (const char* part : {"unsafe", "src=", "@import", "url(", "innerHTML", "eval(", "<iframe"})
    EXPECT_FALSE(has(part)) << part;
  const std::string opening = R"(<script type="application/json" id="data">)";
  const auto begin = text.find(opening) + opening.size();
  const Json data = Json::parse(text.substr(begin, text.find('<', begin) - begin));
  EXPECT_EQ(data["sections"].size(), 1U);
}

TEST(figures_page, where_it_was_not_built_says_how_to_get_it) {
  if (output::has_page()) GTEST_SKIP() << "it was built";
  EXPECT_THROW(output::figures_page(FiguresPage{}), std::runtime_error);
}

}  // namespace

}  // namespace dashpad::test
