// Figures of a study: limits, rows that bottomed out, names in words.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/drawing.hpp"
#include "output/plot/study_figures.hpp"

namespace dashpad {
namespace {

using output::Series;
using output::SeriesStyle;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Speeds 1, 2, 3 m/s over thicknesses 10, 20, 30 mm; the force is 100 N times the speed, and the fastest
/// impact bottoms out on the thinnest pad. The limit is 150 N.
study::StudyAnswers answers(bool drawn) {
  study::StudyAnswers result;
  const study::Spread spread =
      drawn ? study::Spread{study::Uniform{1, 3}} : study::Spread{study::Levels{{1, 2, 3}}};
  const study::Spread thick =
      drawn ? study::Spread{study::Uniform{0.01, 0.03}} : study::Spread{study::Levels{{0.01, 0.02, 0.03}}};
  result.study.factors = {
      {.key = "impactor.speed", .unit = "m/s", .spread = spread, .lowest = {}, .highest = {}},
      {.key = "pad.thickness", .unit = "m", .spread = thick, .lowest = {}, .highest = {}}};
  result.study.responses = {"peak_force"};
  result.responses = {0};
  result.limits = {{"peak_force", 150}};
  result.records.factors.resize(2);
  result.records.responses.resize(1);
  study::Group all{.levels = {}, .places = {}, .drawn = drawn};
  for (const double thickness : {0.01, 0.02, 0.03})
    for (const double speed : {1.0, 2.0, 3.0}) {
      const bool struck = thickness == 0.01 && speed == 3;
      all.places.push_back(result.records.rows.size());
      result.records.rows.push_back(result.records.rows.size());
      result.records.factors[0].push_back(speed);
      result.records.factors[1].push_back(thickness);
      result.records.responses[0].push_back(struck ? none : 100 * speed);
      result.records.statuses.push_back(struck ? Status::bottomed_out : Status::released);
    }
  result.groups = {{.group = all, .distributions = {}, .exceedances = {}, .sensitivities = {}}};
  return result;
}

const UnitSystem& units() { return unit_systems().front(); }

/// The series of a figure of one panel that begin with that label.
std::vector<Series> labelled(const std::vector<output::CaptionedPlot>& figures, const std::string& begin) {
  std::vector<Series> found;
  for (const Series& series : figures.at(0).plot.panels.at(0).series)
    if (series.label.starts_with(begin)) found.push_back(series);
  return found;
}

TEST(StudyFigures, AMapHasTheContourOfItsLimit) {
  const auto maps = output::map_figures(answers(false), units());
  const auto limit = labelled(maps, "limit 150 N");
  ASSERT_EQ(limit.size(), 1U);
  EXPECT_EQ(limit[0].label_place, output::LabelPlace::middle);
  ASSERT_FALSE(limit[0].x.empty());
  for (const double speed : limit[0].x) EXPECT_DOUBLE_EQ(speed, 1.5);
  EXPECT_EQ(maps[0].plot.panels[0].x.label, "Impact speed (m/s)");
  EXPECT_EQ(maps[0].plot.panels[0].y.label, "Thickness of the pad (mm)");
}

TEST(StudyFigures, MapsAndCurvesMarkWhatBottomedOut) {
  const auto on_map = labelled(output::map_figures(answers(false), units()), "bottomed out");
  ASSERT_EQ(on_map.size(), 1U);
  EXPECT_THAT(on_map[0].x, ElementsAre(3));
  EXPECT_THAT(on_map[0].y, ElementsAre(10));
  const auto curves = output::curve_figures(answers(false), units());
  const auto beside_curves = labelled(curves, "thickness of the pad 10 mm: bottomed out");
  ASSERT_EQ(beside_curves.size(), 1U);
  EXPECT_THAT(beside_curves[0].x, ElementsAre(3));
  EXPECT_GT(beside_curves[0].y.at(0), 300);
  const auto line = labelled(curves, "thickness of the pad 10 mm");
  ASSERT_EQ(line.size(), 2U) << "the line and its marks";
  EXPECT_EQ(*beside_curves[0].palette_index % output::colours_by_turn, *line[0].palette_index);
  EXPECT_EQ(labelled(curves, "limit 150 N").size(), 1U);
}

TEST(StudyFigures, ADistributionSaysWhyItEndsBelowAll) {
  const auto line = labelled(output::distribution_figures(answers(true), units()), "11.1 % bottomed out");
  ASSERT_EQ(line.size(), 1U);
  EXPECT_EQ(line[0].style, SeriesStyle::horizontal_line);
  EXPECT_NEAR(line[0].y.at(0), 100.0 * 8 / 9, 1e-9);
}

TEST(StudyFigures, AScatterHasARowOfMarksForWhatBottomedOut) {
  const auto marks = labelled(output::scatter_figures(answers(true), units()), "bottomed out");
  ASSERT_EQ(marks.size(), 1U);
  EXPECT_THAT(marks[0].x, ElementsAre(3));
  EXPECT_GT(marks[0].y.at(0), 300);
}

TEST(StudyFigures, ACurveOverDrawsHasABandOfNineInTen) {
  study::StudyAnswers study_answers = answers(false);
  study_answers.study.factors = {{.key = "impactor.speed", .unit = "m/s", .spread = study::Levels{{1, 2}}},
                                 {.key = "pad.thickness", .unit = "m", .spread = study::Uniform{0.01, 0.03}}};
  std::vector<double> draws;
  for (int i = 1; i <= 100; ++i) draws.push_back(i);
  study_answers.groups.clear();
  for (const double speed : {1.0, 2.0}) {
    study::StudyAnswers::OfGroup group;
    group.group = {.levels = {speed}, .places = {}, .drawn = true};
    group.distributions = {study::distribution(draws, true)};
    study_answers.groups.push_back(group);
  }
  const output::Panel panel = output::curve_figures(study_answers, units()).at(0).plot.panels.at(0);
  const auto band = std::ranges::find(panel.series, SeriesStyle::band, &Series::style);
  ASSERT_NE(band, panel.series.end());
  EXPECT_THAT(band->x, ElementsAre(1, 2));
  EXPECT_THAT(band->y, ElementsAre(5, 5));
  EXPECT_THAT(band->y2, ElementsAre(95, 95));
}

TEST(StudyFigures, IndicesStandBelowEachOtherTheLargestOnTop) {
  study::StudyAnswers study_answers = answers(true);
  study_answers.groups[0].sensitivities = {study::Sensitivity{
      .indices = {{.factor = "impactor.speed", .first = {0.1, 0, 0.2}, .total = {0.2, 0.1, 0.3}},
                  {.factor = "pad.thickness", .first = {0.6, 0.5, 0.7}, .total = {0.8, 0.7, 0.9}}}}};
  const output::Panel panel = output::index_figures(study_answers).at(0).plot.panels.at(0);
  EXPECT_FALSE(panel.y.has_numbers);
  std::vector<std::string> names;
  std::vector<double> heights;
  for (const Series& series : panel.series)
    if (!series.end_label.empty()) {
      names.push_back(series.end_label);
      heights.push_back(series.y.front());
      EXPECT_EQ(series.x.size(), 2U);
    }
  EXPECT_THAT(names, ElementsAre("Thickness of the pad", "Impact speed"));
  EXPECT_GT(heights.at(0), heights.at(1));
  const std::string svg = picture({.panels = {panel}}, output::PictureFormat::svg);
  EXPECT_THAT(svg, ::testing::HasSubstr(">Thickness of the pad<"));
  EXPECT_THAT(svg, ::testing::HasSubstr("data-y-numbers=\"0\""));
}

TEST(StudyFigures, OfManyRowsSomeAreDrawnAtRandom) {
  const std::vector<std::size_t> rows = output::rows_drawn(10'000, 400);
  ASSERT_EQ(rows.size(), 400U);
  EXPECT_TRUE(std::ranges::is_sorted(rows));
  // Of a sequence in which every other row lies in the same half of the range, both halves are there.
  const auto odd = std::ranges::count_if(rows, [](std::size_t row) { return row % 2 == 1; });
  EXPECT_GT(odd, 150);
  EXPECT_LT(odd, 250);
  EXPECT_EQ(output::rows_drawn(3, 400), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(StudyFigures, WhereAllBottomOutTheAxisHasNoNumbers) {
  study::StudyAnswers all = answers(false);
  for (std::size_t i = 0; i < all.records.rows.size(); ++i) {
    all.records.statuses[i] = Status::bottomed_out;
    all.records.responses[0][i] = none;
  }
  const auto curves = output::curve_figures(all, units());
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].plot.panels[0].y.has_numbers);
  EXPECT_TRUE(output::curve_figures(answers(false), units()).at(0).plot.panels.at(0).y.has_numbers);
}

TEST(StudyFigures, WithoutSuchRowsThereAreNoMarks) {
  study::StudyAnswers all_whole = answers(true);
  for (std::size_t i = 0; i < all_whole.records.rows.size(); ++i) {
    all_whole.records.statuses[i] = Status::released;
    all_whole.records.responses[0][i] = 100;
  }
  EXPECT_THAT(labelled(output::scatter_figures(all_whole, units()), "bottomed out"), IsEmpty());
  EXPECT_EQ(output::distribution_figures(all_whole, units()).at(0).plot.panels.at(0).series.size(), 2U);
}

}  // namespace
}  // namespace dashpad
