// What is drawn and what is printed of studies, against their rows, in every system of units.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "example_result.hpp"
#include "output/plot/study_figures.hpp"
#include "output/text/study_answer.hpp"
#include "shown_values.hpp"

namespace dashpad::test {
namespace {

using namespace output;

constexpr double gravity = standard_gravity;

/// A grid of speeds and thicknesses, or draws of both; the least thickness at the highest speed strikes
/// through. Force, acceleration and penetration follow no factor alike.
study::StudyAnswers study_of(bool drawn) {
  study::StudyAnswers of;
  const std::vector<double> speeds{2, 3, 5, 8}, thicknesses{0.01, 0.02, 0.05};
  of.study.title = "A study";
  of.study.factors = {{.key = "impactor.speed", .unit = "m/s", .spread = study::Levels{speeds}},
                      {.key = "pad.thickness", .unit = "m", .spread = study::Levels{thicknesses}}};
  if (drawn)
    of.study.factors[0].spread = study::Uniform{2, 8},
    of.study.factors[1].spread = study::Uniform{0.01, 0.05};
  of.study.responses = {"peak_force", "peak_acceleration", "peak_penetration"};
  of.responses = {0, 1, 2};
  of.limits = {{"peak_force", 700}, {"peak_acceleration", 50 * gravity}};
  of.records.factors.resize(2);
  of.records.responses.resize(3);
  study::StudyAnswers::OfGroup group;
  group.group.drawn = drawn;
  for (const double speed : speeds)
    for (const double thickness : thicknesses) {
      const bool struck = speed == 8 && thickness == 0.01;
      group.group.places.push_back(of.records.rows.size());
      of.records.rows.push_back(of.records.rows.size());
      of.records.factors[0].push_back(speed);
      of.records.factors[1].push_back(thickness);
      of.records.responses[0].push_back(struck ? NAN : 3 * speed / thickness);
      of.records.responses[1].push_back(struck ? NAN : gravity * speed * speed + 1 / thickness);
      of.records.responses[2].push_back(0.3 * thickness * std::sqrt(speed));
      of.records.statuses.push_back(struck ? Status::bottomed_out : Status::released);
    }
  of.records.struck_through = of.records.bottomed = 1;
  of.rows = of.records.rows.size();
  for (std::size_t i = 0; i < 3; ++i) {
    group.distributions.push_back(
        study::distribution(study::values_of(of.study, of.records, group.group, i), drawn));
    group.sensitivities.emplace_back();
  }
  for (std::size_t i = 0; i < 2; ++i)
    group.exceedances.push_back(study::exceedance(study::readings_of(of.study, of.records, group.group, i),
                                                  of.limits[i].value, drawn));
  of.groups = {group};
  return of;
}

study::StudyAnswers cushions() {
  study::StudyAnswers study_answers = study_of(false);
  study_answers.study.base = example_case();
  study_answers.cushion_curves =
      study::CushionCurves{.drops = {{0.6,
                                      3.4,
                                      {{0.05, {1e3, 2e3, 5e3}, {40 * gravity, 30 * gravity, 60 * gravity}},
                                       {0.02, {1e3, 3e3}, {90 * gravity, 80 * gravity}}}}}};
  return study_answers;
}

study::StudyAnswers foams() {
  study::StudyAnswers study_answers = study_of(false);
  study_answers.study.factors = {{.key = "pad.material", .unit = "", .spread = study::Levels{{0, 1, 2}}}};
  study_answers.study.materials = {{.name = "soft"}, {.name = "firm"}, {.name = "hard"}};
  study_answers.study.responses = {"peak_penetration"};
  study_answers.responses = {0};
  study_answers.limits = {{"peak_penetration", 0.03}};
  study_answers.records.factors = {{0, 1, 2}};
  study_answers.records.responses = {{0.04, 0.025, 0.011}};
  study_answers.records.statuses.resize(3);
  study_answers.records.rows.resize(3);
  study_answers.records.struck_through = study_answers.records.bottomed = 0;
  study_answers.groups[0].group.places = {0, 1, 2};
  study_answers.groups[0].exceedances = {study::exceedance(
      study::readings_of(study_answers.study, study_answers.records, study_answers.groups[0].group, 0), 0.03,
      false)};
  study_answers.groups[0].distributions = {study::distribution(study_answers.records.responses[0], false)};
  study_answers.groups[0].sensitivities = {std::nullopt};
  return study_answers;
}

TEST(ShownStudies, AreTheSameInAllUnits) {
  const study::StudyAnswers draws = study_of(true), grid = study_of(false);
  expect_same_in_all_units([&](const UnitSystem& units) {
    std::vector<Plot> plots;
    for (const auto& figures : {distribution_figures(draws, units), scatter_figures(draws, units),
                                distribution_figures(grid, units), curve_figures(grid, units),
                                cushion_figures(cushions(), units), named_figures(foams(), units)}) {
      EXPECT_FALSE(figures.empty());
      for (Plot& plot : plots_of(figures)) plots.push_back(std::move(plot));
    }
    return plots;
  });
  for (const study::StudyAnswers& study_answers : {draws, grid, foams()})
    expect_same_numbers_in_all_units(
        [&](const UnitSystem& units) {
          std::vector<double> all;
          for (const Table& table : study_tables(study_answers, units))
            for (const double number : numbers_in(table)) all.push_back(number);
          for (const double number : numbers_in(factor_table(study_answers, units))) all.push_back(number);
          return all;
        },
        2e-3);
}

TEST(ShownStudies, AreThoseOfTheirRows) {
  const study::StudyAnswers draws = study_of(true), grid = study_of(false);
  const study::Records& records = draws.records;
  for (const UnitSystem& units : unit_systems()) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> sorted, shares;
      for (const double value : records.responses[i])
        if (std::isfinite(value)) sorted.push_back(value);
      std::ranges::sort(sorted);
      for (std::size_t k = 1; k <= sorted.size(); ++k) shares.push_back(100. * double(k) / 12);
      const Panel function = panel_in_si(distribution_figures(draws, units).at(i).plot.panels.at(0));
      expect_values(function.series.at(0).x, sorted, "distribution");
      expect_values(function.series.at(0).y, shares, "shares at or below");
      for (std::size_t factor = 0; factor < 2; ++factor) {
        const Panel scatter = panel_in_si(scatter_figures(draws, units).at(i).plot.panels.at(factor));
        std::vector<double> x, y;
        for (std::size_t row = 0; row < 12; ++row)
          if (std::isfinite(records.responses[i][row])) {
            x.push_back(records.factors[factor][row]);
            y.push_back(records.responses[i][row]);
          }
        expect_values(scatter.series.at(0).x, x, "scatter, x");
        expect_values(scatter.series.at(0).y, y, "scatter, y");
      }
      // A line for each of the three thicknesses, over the four speeds.
      const Panel curves = panel_in_si(curve_figures(grid, units).at(i).plot.panels.at(0));
      for (std::size_t line = 0; line < 3; ++line) {
        std::vector<double> values;
        for (std::size_t speed = 0; speed < 4; ++speed)
          values.push_back(i < 2 && speed == 3 && line == 0 ? HUGE_VAL
                                                            : records.responses[i][3 * speed + line]);
        expect_values(curves.series.at(line).x, {2, 3, 5, 8}, "speeds");
        expect_values(curves.series.at(line).y, values, "line");
      }
      for (const Panel& panel : {function, curves})
        for (const Series& series : panel.series)
          if (series.label.starts_with("limit "))
            expect_values(series.y.empty() ? series.x : series.y, {draws.limits.at(i).value}, series.label);
    }
    const auto drops = cushions().cushion_curves->drops[0].curves;
    const Panel cushion = panel_in_si(cushion_figures(cushions(), units).at(0).plot.panels.at(0));
    for (std::size_t i = 0; i < 2; ++i) {
      expect_values(cushion.series.at(i).x, drops[i].static_stress, "static stress");
      expect_values(cushion.series.at(i).y, drops[i].peak_deceleration, "peak");
    }
    const Panel bars = panel_in_si(named_figures(foams(), units).at(0).plot.panels.at(0));
    for (std::size_t i = 0; i < 3; ++i)
      expect_values(bars.series.at(i).x, {0, std::vector{0.011, 0.025, 0.04}[i]}, "bar");
    expect_values(bars.series.at(3).x, {0.03}, "limit");
  }
}

/// A point for each row, at its two factors, in the class of colour of its value.
TEST(ShownStudies, ColouredPointsAreRows) {
  const study::StudyAnswers draws = study_of(true);
  const study::Records& records = draws.records;
  for (const UnitSystem& units : unit_systems()) {
    const auto figures = coloured_scatter_figures(draws, units);
    ASSERT_EQ(figures.size(), 3U);
    for (const CaptionedPlot& figure : figures) {
      const Panel panel = panel_in_si(figure.plot.panels.at(0));
      const bool speeds_across = panel.x.label.starts_with("Impact speed");
      std::vector<std::pair<double, double>> drawn, rows;
      for (const Series& series : panel.series)
        for (std::size_t i = 0; i < series.x.size(); ++i)
          drawn.emplace_back(std::round(1e6 * series.x[i]), std::round(1e6 * series.y[i]));
      for (std::size_t row = 0; row < 12; ++row)
        rows.emplace_back(std::round(1e6 * records.factors[speeds_across ? 0 : 1][row]),
                          std::round(1e6 * records.factors[speeds_across ? 1 : 0][row]));
      std::ranges::sort(drawn);
      std::ranges::sort(rows);
      EXPECT_EQ(drawn, rows) << figure.plot.title;
    }
  }
}

TEST(ShownStudies, IndicesAreThoseOfTheTable) {
  study::StudyAnswers study_answers = study_of(true);
  study_answers.study.indices = true;
  study_answers.groups[0].sensitivities[1] =
      study::Sensitivity{.indices = {{"impactor.speed", {0.3, 0.2, 0.35}, {0.7, 0.6, 0.75}},
                                     {"pad.thickness", {0.1, 0.05, 0.18}, {0.5, 0.4, 0.55}}},
                         .draws = 99};
  EXPECT_EQ(numbers_in(study_tables(study_answers, unit_system("si")).back()),
            (std::vector<double>{0.3, 0.2, 0.35, 0.7, 0.6, 0.75, 99, 0.1, 0.05, 0.18, 0.5, 0.4, 0.55, 99}));
}

TEST(ShownStudies, IndicesStandUnderTheirNames) {
  study::StudyAnswers study_answers = study_of(true);
  study_answers.groups[0].sensitivities[0] =
      study::Sensitivity{.indices = {{"impactor.speed", {0.3, 0.2, 0.35}, {0.7, 0.6, 0.75}},
                                     {"pad.thickness", {0.1, 0.05, 0.18}, {0.5, 0.4, 0.55}}}};
  const Panel panel = index_figures(study_answers).at(0).plot.panels.at(0);
  std::vector<double> first, total, first_bands, total_bands;
  for (const Series& series : panel.series) {
    const bool is_first = (series.label + series.of).starts_with("by itself");
    if (series.style == SeriesStyle::points) (is_first ? first : total).push_back(series.x.at(0));
    if (series.style == SeriesStyle::band)
      (is_first ? first_bands : total_bands)
          .insert((is_first ? first_bands : total_bands).end(), series.x.begin(), series.x.end());
  }
  EXPECT_THAT(first, testing::ElementsAre(0.3, 0.1));
  EXPECT_THAT(total, testing::ElementsAre(0.7, 0.5));
  EXPECT_THAT(first_bands, testing::ElementsAre(0.2, 0.35, 0.05, 0.18));
  EXPECT_THAT(total_bands, testing::ElementsAre(0.6, 0.75, 0.4, 0.55));
}

}  // namespace
}  // namespace dashpad::test
