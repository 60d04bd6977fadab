// Pictures, drawn by gnuplot as it is installed here.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/end_labels.hpp"
#include "output/plot/rows.hpp"
#include "output/plot/script.hpp"
#include "output/plot/text.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using output::picture;
using output::PictureFormat;
using output::Plot;
using output::SeriesStyle;
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

/// Whether Python's parser accepts the text.
bool is_well_formed(const std::string& xml) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "picture.svg";
  std::ofstream{file, std::ios::binary} << xml;
  const std::string command =
      "python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' '" + file.string() + "'";
  return std::system(command.c_str()) == 0;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (auto place = text.find(part); place != std::string::npos; place = text.find(part, place + 1)) ++result;
  return result;
}

/// Number of rows that gnuplot gets.
std::size_t row_count(const Plot& plot) {
  const std::string script = output::plot_script(plot, PictureFormat::svg);
  const auto begin = script.find("<< END\n"), end = script.find("\nEND\n");
  return static_cast<std::size_t>(std::count(script.begin() + static_cast<std::ptrdiff_t>(begin),
                                             script.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

// --- The files ---

TEST(Plot, IsAnSvgWithItsTexts) {
  const std::string svg = picture(two_lines(), PictureFormat::svg);
  for (const char* text :
       {"A dashboard", "Force on the sphere", "Time (ms)", "Force (kN)", "first", "second", "dashpad 0.1.0"})
    EXPECT_THAT(svg, HasSubstr(">" + std::string{text} + "<"));
  EXPECT_TRUE(is_well_formed(svg));
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
  EXPECT_EQ(picture(two_lines(), PictureFormat::svg), picture(two_lines(), PictureFormat::svg));
}

TEST(Plot, FormatFollowsTheEnding) {
  EXPECT_EQ(output::picture_format("force.svg"), PictureFormat::svg);
  EXPECT_EQ(output::picture_format("a.svg/force.PNG"), PictureFormat::png);
  EXPECT_EQ(output::picture_format("force.time.pdf"), PictureFormat::pdf);
  EXPECT_EQ(output::picture_format("force.jpg"), std::nullopt);
  EXPECT_EQ(output::picture_format("svg"), std::nullopt);
}

// --- Foreign texts ---

TEST(Plot, RunsNothingThatATextSays) {
  test::TemporaryFolder folder;
  const std::string trap = (folder.path() / "pwned").string();
  const std::string command = "touch " + trap;
  for (const std::string& text : std::vector<std::string>{"'; system('" + command + "'); '",
                                                          "`" + command + "`",
                                                          "\"`" + command + "`\"",
                                                          "'.system('" + command + "').'",
                                                          "\\'; system('" + command + "') #",
                                                          "\n!" + command + "\n",
                                                          "a\nEND\nsystem('" + command + "')\n",
                                                          "@ARG0 $(" + command + ") ${HOME}",
                                                          "' \"`" + command + "`\" '",
                                                          "\\",
                                                          "'",
                                                          "''",
                                                          "a''b",
                                                          "'''",
                                                          "a'''b\"@x\"'",
                                                          "\"@x '@y",
                                                          "a''; system('" + command + "') #",
                                                          "a'''; system('" + command + "') #",
                                                          "''; system('" + command + "') #",
                                                          "\"",
                                                          "'\"",
                                                          "{",
                                                          "}",
                                                          "#",
                                                          "\\\n!" + command}) {
    Plot plot = two_lines();
    plot.title = plot.source = text;
    output::Panel& panel = plot.panels[0];
    panel.title = panel.x.label = panel.y.label = panel.series[0].label = text;
    const std::string svg = picture(plot, PictureFormat::svg);
    EXPECT_FALSE(std::filesystem::exists(trap)) << text;
    EXPECT_THAT(svg, HasSubstr("second"));
  }
}

TEST(Plot, ShowsEachCharacterAsItIs) {
  Plot plot = two_lines();
  plot.title = "a'b \"c\" \\n `d` @e {f} g^h i_j 50 % $k #m ''n'' ; ! &#x41; & <l> é µ";
  const std::string svg = picture(plot, PictureFormat::svg);
  EXPECT_THAT(svg,
              HasSubstr("a'b \"c\" \\n `d` @e {f} g^h i_j 50 % $k #m ''n'' ; ! &amp;#x41; &amp; &lt;l> é µ"));
  EXPECT_TRUE(is_well_formed(svg));
}

TEST(Plot, IsWellFormedWithBytesThatAreNoText) {
  Plot plot = two_lines();
  for (int byte = 0; byte < 256; ++byte) plot.title += std::string{"x"} + static_cast<char>(byte);
  plot.panels[0].series[0].label =
      std::string{"\xed\xa0\x80\xef\xbf\xbf\xf4\x90\x80\x80\xc0\x80\x00 ]]> end", 21};
  EXPECT_TRUE(is_well_formed(picture(plot, PictureFormat::svg)));
}

TEST(PlotText, KeepsWhatIsReadable) {
  EXPECT_EQ(output::readable("µ\t€\r\n\x7f𝄞"), "µ €   𝄞");
  EXPECT_EQ(output::readable("a\xff\xc3"), "a��");
  EXPECT_EQ(output::literal("it's"), "'it'.sprintf('%c',39).'s'");
}

TEST(PlotText, IsCutOrGoesOnInTheNextLine) {
  EXPECT_EQ(output::shortened("äöü", 3), "äöü");
  EXPECT_EQ(output::shortened("äöüß", 3), "äö…");
  EXPECT_THAT(output::lines_of("one two three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(output::lines_of("äöüäöü", 4), ElementsAre("äöüä", "öü"));
  EXPECT_THAT(output::lines_of("", 4), ElementsAre());
}

// --- Data ---

TEST(Plot, HasAGapWhereThereIsNoNumber) {
  output::Series series =
      line("gap", {0, 1, 2, 3, 4, 5}, {0, 1, nan, 1, 2, std::numeric_limits<double>::infinity()});
  const std::string script = output::plot_script(plot_of({series}), PictureFormat::svg);
  EXPECT_THAT(script, HasSubstr("\n0 0 0\n1 1 1\n\n3 1 1\n4 2 2\nEND\n"));
  const std::string svg = picture(plot_of({series}), PictureFormat::svg);
  EXPECT_TRUE(is_well_formed(svg));
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

TEST(Plot, DrawsEveryStyleOnEveryAxis) {
  const std::vector<double> x{1, 2, 10, 50}, y{3, 1, 20, 4}, y2{4, 2, 30, 5};
  const Plot plot =
      plot_of({{.label = "line", .style = SeriesStyle::line, .x = x, .y = y},
               {.label = "solid", .style = SeriesStyle::solid_line, .x = x, .y = y2},
               {.label = "dashed", .style = SeriesStyle::dashed_line, .x = y, .y = x},
               {.label = "points", .style = SeriesStyle::points, .x = x, .y = y},
               {.label = "band", .style = SeriesStyle::band, .x = x, .y = y, .y2 = y2, .turn = 0},
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
    }
  }
}

TEST(Plot, DrawsALineThatOnlyCrossesTheWindow) {
  Plot plot = plot_of({line("", {0, 10}, {0, 10})});
  plot.panels[0].x.low = 4;
  plot.panels[0].x.high = 6;
  EXPECT_THAT(output::plot_script(plot, PictureFormat::svg), HasSubstr("\n4 4 4\n6 6 6\n"));
  EXPECT_NO_THROW(picture(plot, PictureFormat::svg));
}

TEST(Plot, GivesOneLabelOneTurnInAllPanels) {
  Plot plot = two_lines();
  plot.panels.push_back(plot.panels[0]);
  std::swap(plot.panels[1].series[0], plot.panels[1].series[1]);
  const std::string svg = picture(plot, PictureFormat::svg);
  EXPECT_EQ(count(svg, "<text>first<"), 1U);
  const std::string script = output::plot_script(plot, PictureFormat::svg);
  EXPECT_EQ(count(script, "#0072B2"), 3U);  // two panels and the legend
}

TEST(Plot, TakesTurnsThatNobodyHasBeenGiven) {
  Plot plot = two_lines();
  plot.panels[0].series[1].turn = 0;
  const std::string script = output::plot_script(plot, PictureFormat::svg);
  EXPECT_THAT(script, HasSubstr("#0072B2"));
  EXPECT_THAT(script, HasSubstr("#D55E00"));
}

// --- Names at the ends of lines ---

std::vector<output::EndLabel> labels_at(const std::vector<double>& heights) {
  std::vector<output::EndLabel> labels;
  for (const double height : heights)
    labels.push_back({.text = std::to_string(labels.size()),
                      .colour = "",
                      .line_end = 1,
                      .line_height = height,
                      .height = height});
  output::make_room(labels);
  return labels;
}

TEST(EndLabels, StayWhereThereIsRoom) {
  const auto labels = labels_at({0.9, 0.1, 0.5});
  EXPECT_EQ(labels[0].text, "1");  // from low to high
  for (const auto& label : labels) EXPECT_DOUBLE_EQ(label.height, label.line_height);
}

TEST(EndLabels, MakeRoomOnEitherSide) {
  const auto labels = labels_at({0.5, 0.5, 0.5});
  EXPECT_DOUBLE_EQ(labels[1].height, 0.5);
  EXPECT_NEAR(labels[1].height - labels[0].height, labels[2].height - labels[1].height, 1e-12);
  EXPECT_GT(labels[1].height - labels[0].height, 0.04);
}

TEST(EndLabels, StayBesideTheAxis) {
  for (const double height : {0.0, 1.0}) {
    const auto labels = labels_at(std::vector<double>(40, height));
    EXPECT_GE(labels.front().height, 0);
    EXPECT_LE(labels.back().height, 1 + 1e-12);
    for (std::size_t i = 1; i < labels.size(); ++i)
      EXPECT_NEAR(labels[i].height - labels[i - 1].height, 1.0 / 39, 1e-12);
  }
}

TEST(Plot, WritesTheNameOfALineAtItsEnd) {
  Plot plot = two_lines();
  plot.panels[0].y.low = 0;
  plot.panels[0].y.high = 4;
  plot.panels[0].series[0].end_label = "at the end";
  EXPECT_EQ(count(picture(plot, PictureFormat::svg), "<text>at the end<"), 1U);
  EXPECT_THAT(output::plot_script(plot, PictureFormat::svg), HasSubstr("from first 3, graph 0.25 "));
}

TEST(Plot, RefusesAnEndLabelOnAnAxisWithoutLimits) {
  Plot plot = two_lines();
  plot.panels[0].series[0].end_label = "end";
  EXPECT_THROW(static_cast<void>(picture(plot, PictureFormat::svg)), std::invalid_argument);
}

// --- Many points ---

TEST(Plot, ThinsLinesWithoutLosingTheirExtremes) {
  constexpr int size = 1'000'000;
  output::Series series = line("noise", std::vector<double>(size), std::vector<double>(size));
  for (int row = 0; row < size; ++row) {
    series.x[row] = row;
    series.y[row] = std::sin(1e3 * row * row);
  }
  series.y[123456] = 77;
  series.y[654321] = -88;
  const Plot plot = plot_of({series});
  EXPECT_LT(row_count(plot), 8000U);
  const std::string script = output::plot_script(plot, PictureFormat::svg);
  EXPECT_THAT(script, HasSubstr("\n123456 77 77\n"));
  EXPECT_THAT(script, HasSubstr("\n654321 -88 -88\n"));
  EXPECT_THAT(script, HasSubstr("\n999999 "));
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

// --- gnuplot itself ---

TEST(Plot, SaysWhichPackageIsMissing) {
  EXPECT_THAT([] { picture(two_lines(), PictureFormat::svg, "/nowhere/gnuplot"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("install the Debian package gnuplot-nox")));
}

/// A program of our own in the place of gnuplot.
class PlotProcess : public ::testing::Test {
 protected:
  std::string program(const std::string& script) {
    const auto file = folder_.path() / "stand-in";
    std::ofstream{file} << "#!/bin/sh\n" << script;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file.string();
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(PlotProcess, RepeatsWhatAFailingProgramSays) {
  const std::string failing = program("echo 'no such terminal' >&2; exit 3");
  EXPECT_THAT([&] { picture(two_lines(), PictureFormat::svg, failing); },
              ThrowsMessage<std::runtime_error>(
                  ::testing::AllOf(HasSubstr("exit status 3"), HasSubstr("no such terminal"))));
}

TEST_F(PlotProcess, SurvivesAProgramThatReadsNothingAndDies) {
  // More than fits between two processes, so that writing meets the closed end.
  Plot plot = two_lines();
  for (int copy = 0; copy < 500; ++copy) {
    output::Series series = line("", {}, {});
    for (int row = 0; row < 200; ++row) {
      series.x.push_back(row / 7.0);
      series.y.push_back(copy / 7.0);
    }
    plot.panels[0].series.push_back(series);
  }
  ASSERT_NE(std::signal(SIGPIPE, SIG_DFL), SIG_ERR);
  const std::string dying = program("kill -9 $$");
  EXPECT_THAT([&] { picture(plot, PictureFormat::svg, dying); },
              ThrowsMessage<std::runtime_error>(HasSubstr("signal 9")));
}

TEST_F(PlotProcess, DoesNotWaitInACircle) {
  // Writes a lot before it reads anything, and on both streams.
  const std::string talker = program("head -c 3000000 /dev/zero; head -c 3000000 /dev/zero >&2; cat");
  const std::string output = picture(two_lines(), PictureFormat::svg, talker);
  EXPECT_GT(output.size(), 3'000'000U);
  EXPECT_THAT(output, EndsWith("unset multiplot\n"));
}

TEST_F(PlotProcess, KeepsSettingsOfTheUserAway) {
  ASSERT_EQ(::setenv("GNUPLOT_LIB", "/somewhere", 1), 0);
  const std::string shows = picture(two_lines(), PictureFormat::svg, program("echo \"$@\"; env"));
  EXPECT_EQ(::unsetenv("GNUPLOT_LIB"), 0);
  EXPECT_THAT(shows, StartsWith("-d\n"));
  EXPECT_THAT(shows, HasSubstr("LC_ALL=C.UTF-8"));
  EXPECT_THAT(shows, Not(HasSubstr("GNUPLOT_LIB")));
}

}  // namespace
}  // namespace dashpad
