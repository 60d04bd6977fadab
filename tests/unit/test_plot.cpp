// Pictures.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/axis_ticks.hpp"
#include "output/plot/drawing.hpp"
#include "output/plot/svg_plot.hpp"
#include "svg_elements.hpp"

namespace dashpad {
namespace {

using output::picture;
using output::PictureFormat;
using output::Plot;
using output::SeriesStyle;
using test::count;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

output::Series line(const std::string& label, std::vector<double> x, std::vector<double> y) {
  return {.label = label, .style = SeriesStyle::line, .x = std::move(x), .y = std::move(y)};
}

Plot plot_of(std::vector<output::Series> series) {
  const output::Panel panel{.title = "Force on the sphere",
                            .x = {.label = "Time (ms)"},
                            .y = {.label = "Force (kN)"},
                            .series = std::move(series)};
  return {.title = "A dashboard", .panels = {panel}, .source = "dashpad 0.1.0"};
}

Plot two_lines() {
  return plot_of({line("first", {0, 1, 2, 3}, {0, 2, 3, 1}), line("second", {0, 1, 2, 3}, {0, 1, 4, 2})});
}

std::string svg_of(const Plot& plot) { return picture(plot, PictureFormat::svg); }

/// Of three runs, s: what other programs do then counts for little.
double min_processor_time(const auto& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 3; ++run) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

/// Number of points that are drawn of the first series.
std::size_t row_count(const Plot& plot) {
  const std::vector<output::PanelDrawing> drawings = output::drawings_of(plot);
  std::size_t rows = 0;
  for (const output::PlotRun& run : drawings.at(0).series.at(0).runs) rows += run.size();
  return rows;
}

// --- The files ---

TEST(Plot, IsAnSvgWithItsTexts) {
  const std::string svg = picture(two_lines(), PictureFormat::svg);
  for (const char* text :
       {"A dashboard", "Force on the sphere", "Time (ms)", "Force (kN)", "first", "second", "dashpad 0.1.0"})
    EXPECT_THAT(svg, HasSubstr(">" + std::string{text} + "<"));
  EXPECT_NO_THROW(test::svg_elements(svg));
}

TEST(Plot, IsAPng) {
  const std::string png = picture(two_lines(), PictureFormat::png);
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_THAT(png, EndsWith("IEND\xae\x42\x60\x82"));
}

TEST(Plot, IsAPdf) {
  const std::string pdf = picture(two_lines(), PictureFormat::pdf);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, EndsWith("%%EOF\n"));
}

TEST(Plot, IsTheSameEachTime) {
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png, PictureFormat::pdf})
    EXPECT_EQ(picture(two_lines(), format), picture(two_lines(), format));
}

TEST(Plot, IsTwiceAsLargeAsAPng) {
  const auto sides = test::numbers_of(test::all_between(svg_of(two_lines()), "viewBox=\"", "\"").at(0));
  const std::string png = picture(two_lines(), PictureFormat::png);
  const auto side = [&](std::size_t place) {
    unsigned int number = 0;
    for (std::size_t i = 0; i < 4; ++i)
      number = (number << 8) | static_cast<unsigned char>(png.at(place + i));
    return number;
  };
  EXPECT_EQ(side(16), 2 * sides.at(2));
  EXPECT_EQ(side(20), 2 * sides.at(3));
}

TEST(Plot, AsksForNothingElsewhere) {
  const std::string svg = svg_of(two_lines());
  for (const char* word : {"<script", "href", "url(", "@import", "@font-face", " id=", " style="})
    EXPECT_THAT(svg, Not(HasSubstr(word)));
  EXPECT_EQ(count(svg, "http"), 1U);  // the name of the language
  EXPECT_THAT(svg, HasSubstr("<title>A dashboard</title>"));
  EXPECT_THAT(svg, HasSubstr("role=\"img\""));
}

TEST(Plot, TellsScriptsWhatItShows) {
  const std::string svg = svg_of(two_lines());
  EXPECT_THAT(svg,
              HasSubstr("<g class=\"dp-panel\" data-x-low=\"0\" data-x-high=\"3\" data-x-log=\"0\" "
                        "data-x-label=\"Time (ms)\" data-x-most=\"9\" data-y-low=\"0\" data-y-high=\"4\""));
  EXPECT_THAT(svg, HasSubstr("<g class=\"dp-series dp-turn-1\" data-label=\"second\" data-style=\"line\">"));
  EXPECT_THAT(test::numbers_on_axes(svg),
              ElementsAre("0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0", "0", "1", "2", "3", "4"));
}

TEST(Plot, FormatFollowsTheEnding) {
  EXPECT_EQ(output::picture_format("force.svg"), PictureFormat::svg);
  EXPECT_EQ(output::picture_format("a.svg/force.PNG"), PictureFormat::png);
  EXPECT_EQ(output::picture_format("force.time.pdf"), PictureFormat::pdf);
  EXPECT_EQ(output::picture_format("force.jpg"), std::nullopt);
  EXPECT_EQ(output::picture_format("svg"), std::nullopt);
}

// --- Foreign texts ---

TEST(Plot, TakesNoTextForMarkup) {
  for (const std::string text :
       {"</text><script>alert(1)</script>", "\" onload=\"alert(1)", "' x='", "<!-- ", "<![CDATA[", "]]>",
        "&amp;", "--", "</style>", "</svg>", "\\", "&#0;", "%s{}", "{0}"}) {
    Plot plot = two_lines();
    plot.title = plot.source = text;
    output::Panel& panel = plot.panels[0];
    panel.title = panel.x.label = panel.y.label = panel.series[0].label = panel.series[0].end_label = text;
    panel.y.low = 0;
    panel.y.high = 4;
    const std::string svg = svg_of(plot);
    EXPECT_NO_THROW(test::svg_elements(svg)) << text;
    EXPECT_EQ(count(svg, "<script"), 0U);
    EXPECT_EQ(count(svg, "onload=\""), 0U);
    EXPECT_THAT(svg, HasSubstr("second"));
    EXPECT_THAT(picture(plot, PictureFormat::pdf), StartsWith("%PDF-"));
  }
}

TEST(Plot, ShowsEachCharacterAsItIs) {
  Plot plot = two_lines();
  plot.title = "a'b \"c\" \\n `d` @e {f} g^h i_j 50 % $k #m ''n'' ; ! &#x41; & <l> é µ";
  const std::string svg = picture(plot, PictureFormat::svg);
  EXPECT_THAT(svg,
              HasSubstr("a&#39;b &quot;c&quot; \\n `d` @e {f} g^h i_j 50 % $k #m &#39;&#39;n&#39;&#39; ; ! "
                        "&amp;#x41; &amp; &lt;l&gt; é µ"));
  EXPECT_NO_THROW(test::svg_elements(svg));
}

TEST(Plot, IsWellFormedWithBytesThatAreNoText) {
  Plot plot = two_lines();
  for (int byte = 0; byte < 256; ++byte) plot.title += std::string{"x"} + static_cast<char>(byte);
  plot.panels[0].series[0].label =
      std::string{"\xed\xa0\x80\xef\xbf\xbf\xf4\x90\x80\x80\xc0\x80\x00 ]]> end", 21};
  EXPECT_NO_THROW(test::svg_elements(picture(plot, PictureFormat::svg)));
}

// --- Data ---

TEST(Plot, HasAGapWhereThereIsNoNumber) {
  output::Series series =
      line("gap", {0, 1, 2, 3, 4, 5}, {0, 1, nan, 1, 2, std::numeric_limits<double>::infinity()});
  const auto lines = test::paths(svg_of(plot_of({series})), "dp-line");
  EXPECT_EQ(count(lines.at(0), "M"), 2U);
  EXPECT_EQ(test::numbers_of(lines.at(0)).size(), 8U);
}

TEST(Plot, LeavesOutSeriesWithoutPoints) {
  Plot plot = two_lines();
  plot.panels[0].series.push_back(line("empty", {}, {}));
  plot.panels[0].series.push_back(line("nothing", {1, 2}, {nan, nan}));
  const std::string svg = picture(plot, PictureFormat::svg);
  EXPECT_THAT(svg, Not(HasSubstr("empty")));
  EXPECT_THAT(svg, Not(HasSubstr("nothing")));
}

TEST(Plot, SaysWhereAPanelHasNoData) {
  Plot plot = two_lines();
  plot.panels.push_back({.title = "Acceleration", .x = {}, .y = {}, .series = {}});
  EXPECT_THAT(picture(plot, PictureFormat::svg), HasSubstr(">no data<"));
}

TEST(Plot, RefusesToDrawNothing) {
  const auto draw = [](const Plot& plot) { return [plot] { picture(plot, PictureFormat::svg); }; };
  const auto has_no_data = ThrowsMessage<std::invalid_argument>(HasSubstr("no data"));
  EXPECT_THAT(draw({}), has_no_data);
  EXPECT_THAT(draw(plot_of({})), has_no_data);
  EXPECT_THAT(draw(plot_of({line("", {1}, {nan})})), has_no_data);
  EXPECT_THAT(draw(plot_of({{.label = "limit", .style = SeriesStyle::vertical_line, .x = {1}}})),
              has_no_data);
  Plot beyond = two_lines();
  beyond.panels[0].x.low = 100;
  EXPECT_THAT(draw(beyond), has_no_data);
  Plot negative = plot_of({line("", {1, 2}, {-1, 0})});
  negative.panels[0].y.logarithmic = true;
  EXPECT_THAT(draw(negative), has_no_data);
}

TEST(Plot, RefusesWhatDoesNotFitTogether) {
  EXPECT_THAT(
      [] {
        picture(plot_of({line("short", {1, 2}, {1})}), PictureFormat::svg);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("\"short\" differ in length")));
  const output::Series band{.label = "band", .style = SeriesStyle::band, .x = {1, 2}, .y = {1, 2}, .y2 = {1}};
  EXPECT_THROW(picture(plot_of({band}), PictureFormat::svg), std::invalid_argument);
  Plot plot = two_lines();
  plot.panels[0].y.low = plot.panels[0].y.high = 1;
  EXPECT_THAT([&] { picture(plot, PictureFormat::svg); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("\"Force (kN)\"")));
  plot = two_lines();
  plot.panels[0].x = {.label = "Time", .logarithmic = true, .low = 0};
  EXPECT_THAT([&] { picture(plot, PictureFormat::svg); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("cannot end at 0")));
}

/// All lines and areas of a plot of one panel lie within its axes.
void expect_inside(const std::string& svg) {
  const auto number = [&](const std::string& name) {
    return std::stod(test::all_between(svg, " data-" + name + "=\"", "\"").at(0));
  };
  const double width = number("width"), height = number("height");
  const auto sides = test::numbers_of(test::all_between(svg, "viewBox=\"", "\"").at(0));
  const std::string axes = test::all_between(svg, "<svg class=\"dp-inside\"", ">").at(0);
  EXPECT_LE(std::stod(test::all_between(axes, " x=\"", "\"").at(0)) + width, sides.at(2));
  EXPECT_LE(std::stod(test::all_between(axes, " y=\"", "\"").at(0)) + height, sides.at(3));
  const auto elements = test::svg_elements(svg);
  for (const test::SvgElement& element : elements) {
    const bool is_drawn = (element.is_of("dp-line") && !element.is_of("dp-across")) ||
                          element.is_of("dp-band") || element.is_of("dp-area");
    if (!is_drawn || std::ranges::none_of(element.ancestors,
                                          [&](std::size_t i) { return elements[i].is_of("dp-inside"); }))
      continue;
    const auto numbers = test::numbers_of(element.attributes.at("d"));
    EXPECT_THAT(numbers, Each(::testing::AllOf(::testing::Ge(0), ::testing::Le(width))));
    for (std::size_t i = 1; i < numbers.size(); i += 2) EXPECT_LE(numbers[i], height);
  }
  for (const std::string& path : test::all_between(svg, " d=\"", "\""))
    EXPECT_EQ(path.find_first_not_of("0123456789. -MLHVahvmlz"), std::string::npos) << path;
}

TEST(Plot, StaysWithinItsAxesWhateverTheNumbers) {
  const std::vector<double> x{-1e300, -1, 0, 1e-300, 2, 3, 1e300}, y{1e300, -1e300, 5, 1e300, 0, nan, 1};
  for (const SeriesStyle style :
       {SeriesStyle::line, SeriesStyle::points, SeriesStyle::band, SeriesStyle::area}) {
    Plot plot = plot_of({{.label = "wide", .style = style, .x = x, .y = y, .y2 = x}});
    expect_inside(svg_of(plot));
    plot.panels[0].x.low = -2;
    plot.panels[0].x.high = 2;
    plot.panels[0].y.low = -10;
    plot.panels[0].y.high = 10;
    const std::string svg = svg_of(plot);
    expect_inside(svg);
    EXPECT_NO_THROW(test::svg_elements(svg));
    EXPECT_THAT(picture(plot, PictureFormat::png), StartsWith("\x89PNG"));
  }
}

TEST(Plot, DrawsEveryStyleOnEveryAxis) {
  const std::vector<double> x{1, 2, 10, 50}, y{3, 1, 20, 4}, y2{4, 2, 30, 5};
  const Plot plot =
      plot_of({{.label = "line", .style = SeriesStyle::line, .x = x, .y = y},
               {.label = "solid", .style = SeriesStyle::solid_line, .x = x, .y = y2},
               {.label = "dashed", .style = SeriesStyle::dashed_line, .x = y, .y = x},
               {.label = "points", .style = SeriesStyle::points, .x = x, .y = y},
               {.label = "band", .style = SeriesStyle::band, .x = x, .y = y, .y2 = y2, .palette_index = 0},
               {.label = "vertical", .style = SeriesStyle::vertical_line, .x = {70, nan}},
               {.label = "horizontal", .style = SeriesStyle::horizontal_line, .y = {40, -3}}});
  for (const bool x_is_logarithmic : {false, true}) {
    for (const bool y_is_logarithmic : {false, true}) {
      Plot variant = plot;
      variant.panels[0].x.logarithmic = x_is_logarithmic;
      variant.panels[0].y.logarithmic = y_is_logarithmic;
      const std::string svg = picture(variant, PictureFormat::svg);
      for (const output::Series& series : plot.panels[0].series)
        EXPECT_THAT(svg, HasSubstr(">" + series.label + "<"));
      EXPECT_NO_THROW(test::svg_elements(svg));
      expect_inside(svg);
    }
  }
}

TEST(Plot, DrawsALineThatOnlyCrossesTheWindow) {
  Plot plot = plot_of({line("", {0, 10}, {0, 10})});
  plot.panels[0].x.low = 4;
  plot.panels[0].x.high = 6;
  const std::string svg = svg_of(plot);
  EXPECT_THAT(svg, HasSubstr("data-y-low=\"4\" data-y-high=\"6\""));
  const auto numbers = test::numbers_of(test::paths(svg, "dp-line").at(0));
  ASSERT_EQ(numbers.size(), 4U);
  EXPECT_EQ(numbers[0], 0);
  EXPECT_EQ(numbers[3], 0);
}

/// So many that they are in the legend.
Plot five_lines() {
  Plot plot = two_lines();
  for (const char* label : {"third", "fourth", "fifth"})
    plot.panels[0].series.push_back(line(label, {0, 1, 2, 3}, {0, 2, 3, 1}));
  return plot;
}

TEST(Plot, GivesOneLabelOneTurnInAllPanels) {
  Plot plot = five_lines();
  plot.panels.push_back(plot.panels[0]);
  std::swap(plot.panels[1].series[0], plot.panels[1].series[1]);
  const std::string svg = picture(plot, PictureFormat::svg);
  EXPECT_EQ(count(svg, ">first<"), 1U);
  EXPECT_EQ(count(svg, "dp-turn-0\" data-label=\"first\""), 2U);
  EXPECT_EQ(count(svg, "dp-sample dp-turn-0\""), 1U);
}

TEST(Plot, TakesTurnsThatNobodyHasBeenGiven) {
  Plot plot = two_lines();
  plot.panels[0].series[1].palette_index = 0;
  const std::string svg = svg_of(plot);
  EXPECT_THAT(svg, HasSubstr("dp-turn-1\" data-label=\"first\""));
  EXPECT_THAT(svg, HasSubstr("dp-turn-0\" data-label=\"second\""));
}

TEST(Plot, WritesTheNameOfALineAtItsEnd) {
  Plot plot = two_lines();
  plot.panels[0].x.high = 4;
  plot.panels[0].series[0].end_label = "at the end";
  const std::string svg = svg_of(plot);
  EXPECT_EQ(count(svg, ">at the end<"), 1U);
  const auto leader = test::numbers_of(test::paths(svg, "dp-leader").at(0));
  const auto line = test::numbers_of(test::paths(svg, "dp-line").at(0));
  EXPECT_EQ(leader.at(0), line.at(6));  // begins where the line ends
  EXPECT_EQ(leader.at(1), line.at(7));
}

/// The label of a series is in the group of that class.
bool is_named_in(const std::string& svg, const std::string& group, const std::string& label) {
  for (const std::string& element : test::all_between(svg, "<g class=\"" + group + " ", "</g>"))
    if (element.find("data-label=\"" + label + "\"") != std::string::npos &&
        element.find(">" + label + "<") != std::string::npos)
      return true;
  return false;
}

TEST(Plot, NamesFewLinesAtTheirEndsAndManyInTheLegend) {
  const std::string few = svg_of(two_lines()), many = svg_of(five_lines());
  EXPECT_EQ(count(few, "dp-entry"), 0U);
  EXPECT_EQ(count(few, "<g class=\"dp-ends\">"), 1U);
  EXPECT_TRUE(is_named_in(few, "dp-end", "first"));
  EXPECT_TRUE(is_named_in(few, "dp-end", "second"));
  EXPECT_EQ(count(many, "<g class=\"dp-entry\""), 5U);
  EXPECT_EQ(count(many, "dp-ends"), 0U);
}

TEST(Plot, HasPointsAndBandsInTheLegend) {
  Plot plot = two_lines();
  plot.panels[0].series.push_back({.label = "tests", .style = SeriesStyle::points, .x = {1}, .y = {1}});
  plot.panels[0].series.push_back({.label = "scatter",
                                   .style = SeriesStyle::band,
                                   .x = {0, 1},
                                   .y = {0, 0},
                                   .y2 = {1, 1},
                                   .palette_index = 0});
  const std::string svg = svg_of(plot);
  EXPECT_EQ(count(svg, "<g class=\"dp-entry\""), 2U);
  for (const char* label : {"tests", "scatter"})
    EXPECT_THAT(svg, HasSubstr("<g class=\"dp-entry\" data-label=\"" + std::string{label} + "\">"));
}

TEST(Plot, DoesNotNameALineAsItsAxisIsNamed) {
  const std::string svg = svg_of(plot_of({line("Force", {0, 1}, {0, 1})}));
  EXPECT_THAT(svg, HasSubstr("data-label=\"Force\""));
  EXPECT_EQ(count(svg, ">Force<"), 0U);
}

TEST(Plot, NamesLinesAcrossOnThem) {
  Plot plot = two_lines();
  plot.panels[0].series.push_back({.label = "limit", .style = SeriesStyle::horizontal_line, .y = {3.6}});
  plot.panels[0].series.push_back({.label = "end", .style = SeriesStyle::vertical_line, .x = {0.5}});
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_named_in(svg, "dp-mark", "limit"));
  EXPECT_TRUE(is_named_in(svg, "dp-mark", "end"));
  EXPECT_EQ(count(svg, "dp-entry"), 0U);
  // Above the line, where nothing else is.
  const std::string limit = test::all_between(svg, "data-label=\"limit\"><text", ">").at(0);
  const double text = std::stod(test::all_between(limit, " y=\"", "\"").at(0));
  EXPECT_LT(text, 320 * (1 - 3.6 / 4));
  EXPECT_GT(text, 12);
}

TEST(Plot, HasRoomForTheNameOfALineAboveAllElse) {
  Plot plot = two_lines();
  plot.panels[0].series.push_back({.label = "limit", .style = SeriesStyle::horizontal_line, .y = {5}});
  plot.panels[0].series.push_back({.label = "peak", .style = SeriesStyle::horizontal_line, .y = {4.8}});
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_named_in(svg, "dp-mark", "limit"));
  EXPECT_TRUE(is_named_in(svg, "dp-mark", "peak"));
}

TEST(Plot, HasLinesAcrossInTheLegendWhereTheirNamesHaveNoRoom) {
  Plot plot = two_lines();
  for (int i = 0; i < 5; ++i)
    plot.panels[0].series.push_back(
        {.label = "limit " + std::to_string(i), .style = SeriesStyle::horizontal_line, .y = {0.5 + 0.7 * i}});
  EXPECT_EQ(count(svg_of(plot), "<g class=\"dp-entry\""), 5U);
  plot = two_lines();
  plot.panels[0].series.push_back(
      {.label = std::string(80, 'm'), .style = SeriesStyle::horizontal_line, .y = {2}});
  EXPECT_EQ(count(svg_of(plot), "<g class=\"dp-entry\""), 1U);
}

TEST(Plot, NamesABracketWithinIt) {
  Plot plot = two_lines();
  plot.panels[0].series.push_back({.label = "HIC",
                                   .style = SeriesStyle::solid_line,
                                   .x = {1, 1, 3, 3},
                                   .y = {0.3, 0.1, 0.1, 0.3},
                                   .label_place = output::LabelPlace::middle});
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_named_in(svg, "dp-mark", "HIC"));
  EXPECT_FALSE(is_named_in(svg, "dp-end", "HIC"));
  const std::string text = test::all_between(svg, "data-label=\"HIC\"><text", ">").at(0);
  const double width = std::stod(test::all_between(svg, "data-width=\"", "\"").at(0));
  EXPECT_NEAR(std::stod(test::all_between(text, " x=\"", "\"").at(0)), width * 2 / 3, 0.1);
}

TEST(Plot, NamesALineThatEndsEarlyBesideItsEnd) {
  Plot plot = two_lines();
  plot.panels[0].series[0] = line("early", {0, 1}, {0, 3.5});
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_named_in(svg, "dp-mark", "early"));
  EXPECT_FALSE(is_named_in(svg, "dp-end", "early"));
  EXPECT_EQ(count(svg, "dp-leader\""), 0U);
}

TEST(Plot, DrawsThePaleEdgesOfALineBelowIt) {
  Plot plot = two_lines();
  plot.panels[0].series[0].is_cased = true;
  const auto lines = test::paths(svg_of(plot), "dp-line");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], lines[1]);
}

TEST(Plot, PointsAnArrowAlongALine) {
  // Its tip, then the two corners behind it.
  const auto arrow = [](output::Series series) {
    series.has_arrow = true;
    const std::vector<std::string> all = test::paths(svg_of(plot_of({std::move(series)})), "dp-shape");
    return all.size() == 1 ? test::numbers_of(all.front()) : std::vector<double>{};
  };
  const std::vector<double> there = arrow(line("there", {0, 1}, {1, 1})),
                            back = arrow(line("back", {0, 1, 0}, {0, 1, 0})),
                            down = arrow(line("down", {1, 1}, {1, 0}));
  ASSERT_THAT(std::vector({there.size(), back.size(), down.size()}), Each(6));
  EXPECT_GT(there[0], there[2] + 10);
  EXPECT_NEAR(there[1], (there[3] + there[5]) / 2, 0.02);
  EXPECT_LT(back[0], back[2]);
  EXPECT_GT(back[1], back[3]);
  EXPECT_GT(down[1], down[3] + 10);
  EXPECT_TRUE(test::paths(svg_of(two_lines()), "dp-shape").empty());
}

TEST(Plot, HasNoArrowWhereALineIsTooShortForOne) {
  output::Series dot = line("dot", {1, 1}, {1, 1});
  dot.has_arrow = true;
  const std::string svg = svg_of(plot_of({dot, line("line", {0, 2}, {0, 2})}));
  EXPECT_THAT(svg, Not(HasSubstr("dp-arrow")));
}

TEST(Plot, BreaksTitlesAtItsOwnWidth) {
  Plot plot = two_lines();
  const std::string words = "Peak deceleration of the head over the thickness of the pad that it strikes";
  plot.panels[0].title = plot.panels[0].x.label = plot.panels[0].y.label = words;
  EXPECT_EQ(count(svg_plot(plot, output::PlotStyle::none, 900), ">" + words + "<"), 3U);
  const std::string narrow = svg_plot(plot, output::PlotStyle::none, 480);
  EXPECT_EQ(count(narrow, ">" + words + "<"), 0U);
  EXPECT_EQ(count(narrow, "strikes<"), 3U);
}

// --- Many points ---

TEST(Plot, ThinsLinesWithoutLosingTheirExtremes) {
  constexpr std::size_t size = 1'000'000;
  output::Series series = line("noise", std::vector<double>(size), std::vector<double>(size));
  for (std::size_t row = 0; row < size; ++row) {
    const auto x = static_cast<double>(row);
    series.x[row] = x;
    series.y[row] = std::sin(1e3 * x * x);
  }
  series.y[123456] = 77;
  series.y[654321] = -88;
  const Plot plot = plot_of({series});
  EXPECT_LT(row_count(plot), 8000U);
  const auto drawings = output::drawings_of(plot);
  const output::PlotRun& run = drawings[0].series[0].runs[0];
  EXPECT_EQ(std::ranges::max(run, {}, &output::PlotRow::y).x, 123456);
  EXPECT_EQ(std::ranges::min(run, {}, &output::PlotRow::y).x, 654321);
  EXPECT_EQ(run.back().x, 999999);
  EXPECT_LT(svg_of(plot).size(), 150'000U);
  // A renderer that looks at each point many times takes many times as long as to sort them, on any machine.
  const double drawing_time = min_processor_time([&] { svg_of(plot); });
  const double sorting_time = min_processor_time([y = series.y] {
    std::vector<double> sorted = y;
    std::ranges::sort(sorted);
  });
  EXPECT_LT(drawing_time, 20 * sorting_time);
}

TEST(Plot, ThinsManyPointsButNotFew) {
  output::Series series{.label = "", .style = SeriesStyle::points};
  for (int row = 0; row < 20'000; ++row) {
    series.x.push_back(row % 100);
    series.y.push_back(row % 10);
  }
  EXPECT_EQ(row_count(plot_of({series})), 20'000U);
  series.x.push_back(0);
  series.y.push_back(0);
  EXPECT_EQ(row_count(plot_of({series})), 100U);
}

}  // namespace
}  // namespace dashpad
